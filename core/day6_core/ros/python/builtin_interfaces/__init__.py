"""The ROS package builtin_interfaces; its interface texts are in share/builtin_interfaces."""
