"""The ROS package nav_msgs; its interface texts are in share/nav_msgs."""
