"""The ROS package unique_identifier_msgs; its interface texts are in share/unique_identifier_msgs."""
