"""The ROS package std_msgs; its interface texts are in share/std_msgs."""
