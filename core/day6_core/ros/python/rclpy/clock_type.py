"""The kinds of clock: ROS, system and steady time."""

from rclpy._rclpy_pybind11 import ClockType as ClockType
