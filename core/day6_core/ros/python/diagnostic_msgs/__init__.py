"""The ROS package diagnostic_msgs; its interface texts are in share/diagnostic_msgs."""
