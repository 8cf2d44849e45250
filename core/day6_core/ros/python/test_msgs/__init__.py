"""The ROS package test_msgs; its interface texts are in share/test_msgs."""
