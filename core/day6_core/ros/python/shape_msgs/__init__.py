"""The ROS package shape_msgs; its interface texts are in share/shape_msgs."""
