"""The ROS package composition_interfaces; its interface texts are in share/composition_interfaces."""
