"""The ROS package statistics_msgs; its interface texts are in core/ros/share/statistics_msgs."""
