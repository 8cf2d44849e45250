"""The ROS package trajectory_msgs; its interface texts are in share/trajectory_msgs."""
