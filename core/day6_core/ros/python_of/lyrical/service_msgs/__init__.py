"""The ROS package service_msgs; its interface texts are in share/service_msgs."""
