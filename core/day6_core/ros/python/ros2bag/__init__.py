"""What programs import of ros2bag."""
