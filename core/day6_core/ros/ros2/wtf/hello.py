"""`ros2 wtf hello`, an alias of `ros2 doctor hello`."""

from day6_core.ros.ros2.doctor.hello import SUMMARY, add_arguments, main

__all__ = ["SUMMARY", "add_arguments", "main"]
