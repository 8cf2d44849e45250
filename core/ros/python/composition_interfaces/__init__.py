"""The ROS package composition_interfaces; its interface texts are in core/ros/share/composition_interfaces."""
