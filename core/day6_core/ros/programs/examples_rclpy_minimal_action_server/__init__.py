"""Small action servers: the examples of real ROS, by their names."""
