"""The ROS package turtlesim; its interface texts are in share/turtlesim."""
