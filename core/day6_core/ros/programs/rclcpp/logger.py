"""The logger of rclcpp: how a message names its file."""

from __future__ import annotations

import functools
from pathlib import Path

from day6_core.ros import programs
from rclpy.impl.rcutils_logger import RcutilsLogger

_PROGRAMS = Path(programs.__file__).resolve().parent


class CppLogger(RcutilsLogger):
    """Names files as the nodes of a binary installation do.

    There `__FILE__` begins with a dot for the folder of the package's sources (Debian builds with `-ffile-prefix-map=<folder>=.`;
    of turtlebot4_node in Humble, `ros2 topic echo /rosout` shows `file: ./src/turtlebot4.cpp`). Here it is the file, function and
    line of day6-tui's own program that logs: those of a C++ source would name what is not here.
    """

    def _written(self, path: str) -> str:
        return _below_package(path)


@functools.lru_cache
def _below_package(path: str) -> str:
    file = Path(path).resolve()
    return "/".join((".", *file.relative_to(_PROGRAMS).parts[1:])) if file.is_relative_to(_PROGRAMS) else path
