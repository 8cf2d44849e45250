"""The ROS package rcl_interfaces; its interface texts are in core/ros/share/rcl_interfaces."""
