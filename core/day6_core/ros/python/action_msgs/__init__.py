"""The ROS package action_msgs; its interface texts are in share/action_msgs."""
