"""The ROS package type_description_interfaces; its interface texts are in share/type_description_interfaces."""
