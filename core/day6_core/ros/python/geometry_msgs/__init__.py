"""The ROS package geometry_msgs; its interface texts are in share/geometry_msgs."""
