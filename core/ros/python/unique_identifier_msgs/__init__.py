"""The ROS package unique_identifier_msgs; its interface texts are in core/ros/share/unique_identifier_msgs."""
