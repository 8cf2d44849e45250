"""The ROS package logging_demo; its interface texts are in share/logging_demo."""
