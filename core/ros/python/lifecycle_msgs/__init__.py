"""The ROS package lifecycle_msgs; its interface texts are in core/ros/share/lifecycle_msgs."""
