"""The note in which an installed package lists its C++ programs, left out by its build, for `ros2 run` and launch to read."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from day6_core.ros.program_index import executables

NOTE = "share/ament_index/resource_index/day6_left_out"
"""The resource of the ament index in which a package lists its programs that were not built, one per line."""


def replacements(package: str, left_out: Iterable[str]) -> list[str]:
    """Return those of a package's left-out programs that day6-tui has in a package of that name; these are started instead.

    A built package hides the underlying one of the same name with all its programs: after building ros2/demos there would be
    no demo_nodes_cpp talker any more.
    """
    ours = executables(package)
    return [name for name in left_out if name in ours]


def why_not(prefix: str, package: str, executable: str) -> str:
    """Return a line with the reason why a program was not built; empty if the build noted none."""
    if executable not in noted_programs(prefix, package):
        return ""
    return (
        f"\n('{executable}' is a C++ program: day6-tui has no compiler, so 'colcon build' left it out of '{package}'; "
        "a real ROS 2 builds and runs it)"
    )


def noted_programs(prefix: str, package: str) -> list[str]:
    """Return the programs that the build of an installed package left out."""
    try:
        return Path(prefix, NOTE, package).read_text(encoding="utf-8", errors="replace").split()
    except OSError:
        return []
