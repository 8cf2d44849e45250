"""The ROS package turtlesim; its interface texts are in core/ros/share/turtlesim."""
