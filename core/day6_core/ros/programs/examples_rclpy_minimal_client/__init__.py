"""The smallest clients: the examples of real ROS, by their names."""
