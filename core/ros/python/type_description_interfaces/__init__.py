"""The ROS package type_description_interfaces; its interface texts are in core/ros/share/type_description_interfaces."""
