"""The ROS package stereo_msgs; its interface texts are in share/stereo_msgs."""
