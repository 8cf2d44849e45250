"""Where the log lines of the libraries go that rosbag2_py wraps: rosbag2_cpp, rosbag2_storage and its plugins."""

from __future__ import annotations

from collections.abc import Callable

Log = Callable[[str, str, str], object]
"""Gets a level as rclpy names it ("INFO"), the name of a logger, and a text."""


def to_console(level: str, logger: str, text: str) -> None:
    """Log as a process of its own does. Programs inside day6-tui have another console, and pass their own `Log`."""
    from rclpy.logging import LoggingSeverity, get_logger

    get_logger(logger).log(text, LoggingSeverity[level])


def quiet(level: str, logger: str, text: str) -> None:
    """Log nothing."""
