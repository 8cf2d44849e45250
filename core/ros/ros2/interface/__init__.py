"""`ros2 interface …`."""

SUMMARY = "Show information about ROS interfaces"
