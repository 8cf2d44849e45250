"""The ROS package day6_world; its interface texts are in share/day6_world."""
