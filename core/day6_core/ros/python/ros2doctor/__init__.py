"""What programs import of ros2doctor."""
