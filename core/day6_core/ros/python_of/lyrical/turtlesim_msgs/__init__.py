"""The ROS package turtlesim_msgs; its interface texts are in share/turtlesim_msgs."""
