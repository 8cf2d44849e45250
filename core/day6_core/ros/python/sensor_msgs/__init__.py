"""The ROS package sensor_msgs; its interface texts are in share/sensor_msgs."""
