"""The ROS package rcl_interfaces; its interface texts are in share/rcl_interfaces."""
