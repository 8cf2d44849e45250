"""The ROS package diagnostic_msgs; its interface texts are in core/ros/share/diagnostic_msgs."""
