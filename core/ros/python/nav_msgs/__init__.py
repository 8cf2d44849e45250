"""The ROS package nav_msgs; its interface texts are in core/ros/share/nav_msgs."""
