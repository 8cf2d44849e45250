"""The ROS package statistics_msgs; its interface texts are in share/statistics_msgs."""
