"""What programs import of ros2param."""
