"""Which task builds a package: by its type."""

from __future__ import annotations

from collections.abc import Callable

from day6_tui.core.workspace import build_cmake, build_python
from day6_tui.core.workspace.jobs import Work
from day6_tui.core.workspace.packages import Package
from day6_tui.core.workspace.settings import Settings

BUILD_TOOL = "colcon"
"""What `.built_by` says: the trees are those of colcon, which may go on building in them."""

Task = Callable[[Package, Settings, Work], int]

_TASKS: dict[str, Task] = {
    "python": build_python.build,
    "ros.ament_python": build_python.build,
    "cmake": build_cmake.build,
    "ros.ament_cmake": build_cmake.build,
    "ros.cmake": build_cmake.build,
    "ros.catkin": build_cmake.build,
}


def find_task(package: Package) -> Task | None:
    """Return what builds a package, None where its build type is unknown."""
    return _TASKS.get(package.type)
