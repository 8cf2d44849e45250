"""Loggers and their levels."""

from __future__ import annotations

import os
from pathlib import Path

from rclpy._day6.incidental import also
from rclpy._day6.log_file import logging_directory
from rclpy._day6.logging_settings import PROCESS
from rclpy._day6.withdrawn import withdraw
from rclpy.impl.logging_severity import LoggingSeverity as LoggingSeverity
from rclpy.impl.rcutils_logger import RcutilsLogger

__getattr__ = also(__name__)

_root_logger = RcutilsLogger()


def get_logger(name: str) -> RcutilsLogger:
    """Return a logger by name; parts of the name are separated by dots.

    Raises:
        ValueError: for an empty name.
    """
    if not name:
        raise ValueError("Logger name must not be empty.")
    return _root_logger.get_child(name)


def initialize() -> None:
    """Do nothing: logging is always ready."""


def shutdown() -> None:
    """Clear the levels that were set."""
    PROCESS.reset()


def clear_config() -> None:
    """Reset levels and format to their initial values."""
    shutdown()
    initialize()


def set_logger_level(name: str, level: int | LoggingSeverity, detailed_error: bool = False) -> None:
    """Set a logger's level.

    Raises:
        ValueError: for a number that isn't a level.
    """
    PROCESS.set_level(name, int(LoggingSeverity(level)))


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """Return the effective level of a logger, its own or that of a parent."""
    return LoggingSeverity(PROCESS.effective_level(name))


def get_logger_level(name: str) -> LoggingSeverity:
    """Return the level set for exactly that logger, UNSET if none is."""
    return LoggingSeverity(PROCESS.level(name))


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the level with this name (in any case).

    Raises:
        RuntimeError: if there is none.
    """
    if not isinstance(log_severity, str):
        raise TypeError(
            "rclpy_logging_severity_level_from_string(): incompatible function arguments. "
            f"The following argument types are supported:\n    1. (arg0: str) -> int\n\nInvoked with: {log_severity!r}"
        )
    try:
        return LoggingSeverity[log_severity.upper()]
    except KeyError:
        raise RuntimeError("Failed to get severity name") from None


def get_logging_directory() -> Path:
    """Return the folder of log files (ROS_LOG_DIR, else log in ROS_HOME, else ~/.ros/log)."""
    return logging_directory(os.environ)


withdraw(__name__)
