"""The ROS package lifecycle_msgs; its interface texts are in share/lifecycle_msgs."""
