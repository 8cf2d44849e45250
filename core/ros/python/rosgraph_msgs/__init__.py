"""The ROS package rosgraph_msgs; its interface texts are in core/ros/share/rosgraph_msgs."""
