"""What programs import of ros2run."""
