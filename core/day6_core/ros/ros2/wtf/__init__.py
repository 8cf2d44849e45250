"""`ros2 wtf`, an alias of `ros2 doctor`."""

from day6_core.ros.ros2.doctor import add_arguments, main

__all__ = ["SUMMARY", "add_arguments", "main"]

SUMMARY = "Use `wtf` as alias to `doctor`"
