"""The ROS package std_msgs; its interface texts are in core/ros/share/std_msgs."""
