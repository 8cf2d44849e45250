"""The demos that real ROS has in C++ (package demo_nodes_cpp): what they do and say, in Python."""
