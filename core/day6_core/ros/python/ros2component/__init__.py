"""What programs import of ros2component."""
