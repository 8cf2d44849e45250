"""The ROS package stereo_msgs; its interface texts are in core/ros/share/stereo_msgs."""
