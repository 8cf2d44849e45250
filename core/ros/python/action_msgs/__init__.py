"""The ROS package action_msgs; its interface texts are in core/ros/share/action_msgs."""
