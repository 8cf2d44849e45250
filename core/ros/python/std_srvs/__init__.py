"""The ROS package std_srvs; its interface texts are in core/ros/share/std_srvs."""
