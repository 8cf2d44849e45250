"""The demos that real ROS has in Python (package demo_nodes_py): what they do and say."""
