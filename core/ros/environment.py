"""The paths of the ROS side of day6-tui, and the environment that makes a plain `python3 FILE` a ROS program."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from pathlib import Path

from day6_tui.core.ros.distribution import DISTRO

_HERE = Path(__file__).resolve().parent
PYTHON_PATH = _HERE / "python"
SHARE_PATH = _HERE / "share"
LAUNCH_PROCESS = _HERE / "ros2" / "launch" / "_process"
"""The package Python runs for a launch, or for one of our programs in it; `launch` starts it but imports nothing of it."""

_VARIABLES = {
    "ROS_DISTRO": DISTRO,
    "ROS_VERSION": "2",
    "ROS_PYTHON_VERSION": "3",
}


def activate() -> None:
    """Put `core/ros/python` on this process's `sys.path`, so that `import rclpy` and `import std_msgs.msg` import ours."""
    path = str(PYTHON_PATH)
    if path not in sys.path:
        sys.path.insert(0, path)


def is_foreign_ros(entry: str) -> bool:
    """Return whether a PYTHONPATH entry belongs to a real ROS installation (its rclpy must not shadow ours)."""
    folder = Path(entry)
    return folder != PYTHON_PATH and (folder / "rclpy").is_dir()


def program_environment(base: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return the variables for a student's process: our folders first on PYTHONPATH and PATH, a sourced real ROS removed.

    `base` is the environment to start from, by default this process's. Other PYTHONPATH entries are kept.
    """
    env = dict(os.environ if base is None else base)
    kept = [entry for entry in env.get("PYTHONPATH", "").split(os.pathsep) if entry and not is_foreign_ros(entry)]
    ours = str(PYTHON_PATH)
    env["PYTHONPATH"] = os.pathsep.join([ours, *(entry for entry in kept if entry != ours)])
    from day6_tui.core.ros.executables import with_executables

    env["PATH"] = with_executables(env.get("PATH", os.defpath))
    if os.name == "nt":
        env["DAY6_PYTHON"] = sys.executable
    env.update(_VARIABLES)
    return env


def as_program(env: dict[str, str]) -> dict[str, str]:
    """Return `env` if it is that of a ROS program, else one based on it (a real terminal, perhaps with a sourced workspace)."""
    return env if str(PYTHON_PATH) in env.get("PYTHONPATH", "").split(os.pathsep) else program_environment(env)
