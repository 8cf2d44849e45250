"""The ROS package action_tutorials_interfaces; its interface texts are in share/action_tutorials_interfaces."""
