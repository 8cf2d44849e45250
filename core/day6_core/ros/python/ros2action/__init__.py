"""What programs import of ros2action."""
