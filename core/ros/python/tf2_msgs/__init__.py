"""The ROS package tf2_msgs; its interface texts are in core/ros/share/tf2_msgs."""
