"""What programs import of ros2interface."""
