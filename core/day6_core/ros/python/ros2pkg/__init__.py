"""What programs import of ros2pkg."""
