"""What programs import of ros2lifecycle."""
