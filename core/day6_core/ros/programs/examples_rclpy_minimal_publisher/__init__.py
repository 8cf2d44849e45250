"""The smallest publishers: the examples of real ROS, by their names."""
