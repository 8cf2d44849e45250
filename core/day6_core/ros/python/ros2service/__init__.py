"""What programs import of ros2service."""
