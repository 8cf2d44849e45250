"""What programs import of ros2node."""
