"""The ROS package shape_msgs; its interface texts are in core/ros/share/shape_msgs."""
