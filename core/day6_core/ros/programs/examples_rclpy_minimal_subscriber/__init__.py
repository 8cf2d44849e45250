"""The smallest subscribers: the examples of real ROS, by their names."""
