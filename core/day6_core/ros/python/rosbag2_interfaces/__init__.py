"""The ROS package rosbag2_interfaces; its interface texts are in share/rosbag2_interfaces."""
