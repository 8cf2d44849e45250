"""The ROS package service_msgs; its interface texts are in core/ros/share/service_msgs."""
