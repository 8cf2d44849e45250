"""The ROS package rosgraph_msgs; its interface texts are in share/rosgraph_msgs."""
