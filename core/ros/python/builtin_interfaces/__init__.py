"""The ROS package builtin_interfaces; its interface texts are in core/ros/share/builtin_interfaces."""
