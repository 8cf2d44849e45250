"""The ROS package example_interfaces; its interface texts are in share/example_interfaces."""
