"""What programs import of ros2topic."""
