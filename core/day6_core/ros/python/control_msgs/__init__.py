"""The ROS package control_msgs; its interface texts are in share/control_msgs."""
