"""A pupil's file with the name of one of Python's modules hurts here as on real ROS.

Real rclpy loads concurrent.futures, yaml and numpy when it is imported, and this one doesn't. They fail where the program's
folder has a file in the place of a module that they need, so then they are imported here too.
"""

from __future__ import annotations

import sys
from os.path import isfile

_NEEDED = (
    "concurrent", "copyreg", "datetime", "logging", "math", "numbers", "string", "struct", "textwrap", "warnings",
)  # fmt: skip
"""Modules of Python that they need and this rclpy doesn't (measured with rclpy 9.1.2: each as an own file beside a talker)."""


def fail_as_real() -> None:
    """Import what real rclpy imports, if a file beside the program may break it. Raises what that raises."""
    folder = sys.path[0] if sys.path else ""
    if any(isfile(f"{folder or '.'}/{name}.py") for name in _NEEDED):
        from importlib import import_module

        for module in ("concurrent.futures", "yaml", "numpy"):
            import_module(module)
