"""The ROS package tf2_msgs; its interface texts are in share/tf2_msgs."""
