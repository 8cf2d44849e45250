"""The ROS package visualization_msgs; its interface texts are in share/visualization_msgs."""
