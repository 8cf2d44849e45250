"""What programs import of ros2multicast."""
