"""The ROS package trajectory_msgs; its interface texts are in core/ros/share/trajectory_msgs."""
