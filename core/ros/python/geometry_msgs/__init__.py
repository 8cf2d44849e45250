"""The ROS package geometry_msgs; its interface texts are in core/ros/share/geometry_msgs."""
