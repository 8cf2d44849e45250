"""The ROS package example_interfaces; its interface texts are in core/ros/share/example_interfaces."""
