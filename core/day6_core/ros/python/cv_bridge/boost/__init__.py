"""Holds the module that is C++ in real ROS."""
