"""Modules of rclpy that Lyrical removed: its path in the older distributions."""
