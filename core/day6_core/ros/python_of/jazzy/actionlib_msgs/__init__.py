"""The ROS package actionlib_msgs; its interface texts are in share/actionlib_msgs."""
