"""The ROS package std_srvs; its interface texts are in share/std_srvs."""
