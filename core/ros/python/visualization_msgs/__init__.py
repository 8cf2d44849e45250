"""The ROS package visualization_msgs; its interface texts are in core/ros/share/visualization_msgs."""
