"""The ROS package actionlib_msgs; its interface texts are in core/ros/share/actionlib_msgs."""
