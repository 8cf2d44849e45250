"""The ROS package sensor_msgs; its interface texts are in core/ros/share/sensor_msgs."""
