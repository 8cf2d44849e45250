"""The paths of the ROS side of day6-tui, and the environment that makes a plain `python3 FILE` a ROS program."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from day6_core.ros import differences, distribution
from day6_core.ros.home_python import VARIABLE, our_packages

_HERE = Path(__file__).resolve().parent
PYTHON_PATH = _HERE / "python"
SHARE_PATH = _HERE / "share"
LAUNCH_PROCESS = _HERE / "ros2" / "launch" / "_process"
"""The package Python runs for a launch, or for one of our programs in it; `launch` starts it but imports nothing of it."""


def python_folders() -> list[str]:
    """Return what a program has on its Python path: what every distribution has, then what this one has besides."""
    return [str(PYTHON_PATH), distribution.python_folder(distribution.current())]


def _variables() -> dict[str, str]:
    return {"ROS_DISTRO": distribution.current(), "ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}


def shipped_packages() -> list[str]:
    """Return the packages that come with day6-tui in this distribution, sorted."""
    return list(filter(differences.has_package, _all_packages()))


@cache
def _all_packages() -> list[str]:
    """The packages of all distributions, sorted: looked for once, `ros2` asks hundreds of times."""
    return sorted(path.parent.name for path in SHARE_PATH.glob("*/package.xml"))


def activate() -> None:
    """Put our packages on this process's `sys.path`, so that `import rclpy` and `import std_msgs.msg` import ours."""
    wanted = python_folders()
    others = [entry for entry in sys.path if entry in wanted or not _is_ours(entry)]
    sys.path[:] = [*(folder for folder in wanted if folder not in others), *others]


def is_foreign_ros(entry: str) -> bool:
    """Return whether a PYTHONPATH entry belongs to a real ROS installation (its rclpy must not shadow ours)."""
    folder = Path(entry)
    return folder != PYTHON_PATH and (folder / "rclpy").is_dir()


def _is_ours(entry: str) -> bool:
    return entry == str(PYTHON_PATH) or distribution.on_path([entry]) is not None


def program_environment(base: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return the variables for a student's process: our folders first on PYTHONPATH and PATH, a sourced real ROS removed.

    `base` is the environment to start from, by default this process's. Other PYTHONPATH entries are kept.
    """
    env = dict(os.environ if base is None else base)
    kept = [entry for entry in env.get("PYTHONPATH", "").split(os.pathsep) if entry and not is_foreign_ros(entry)]
    env["PYTHONPATH"] = os.pathsep.join([*python_folders(), *(entry for entry in kept if not _is_ours(entry))])
    from day6_core.ros.executables import with_executables

    env["PATH"] = with_executables(env.get("PATH", os.defpath))
    env[VARIABLE] = our_packages()
    if os.name == "nt":
        env["DAY6_PYTHON"] = sys.executable
    env.update(_variables())
    return env


def as_program(env: dict[str, str]) -> dict[str, str]:
    """Return `env` if it is that of a ROS program, else one based on it (a real terminal, perhaps with a sourced workspace)."""
    return env if str(PYTHON_PATH) in env.get("PYTHONPATH", "").split(os.pathsep) else program_environment(env)
