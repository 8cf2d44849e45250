"""The ROS package test_msgs; its interface texts are in core/ros/share/test_msgs."""
