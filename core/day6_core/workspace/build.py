"""Chooses the task that builds a package, by the package's type."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path

from day6_core.workspace import build_cmake, build_python
from day6_core.workspace.files import NotOurOutput
from day6_core.workspace.jobs import Work
from day6_core.workspace.packages import Package
from day6_core.workspace.settings import BuildSettings

BUILD_TOOL = "colcon"
"""The text of `.built_by`: the trees are colcon's, so the real one may go on building in them."""

Task = Callable[[Package, BuildSettings, Work], int]

_TASKS: dict[str, Task] = {
    "python": build_python.build,
    "ros.ament_python": build_python.build,
    "cmake": build_cmake.build,
    "ros.ament_cmake": build_cmake.build,
    "ros.cmake": build_cmake.build,
    "ros.catkin": build_cmake.build,
}


_LEFT_BY_BUILDS = ("colcon_", "prefix_override", "cmake_args.last", "CMakeCache.txt", "pytest.xml", "install.log")
"""How names of files begin that colcon or CMake leave in a build folder."""

_LOGGERS = {
    "python": "colcon.colcon_core.task.python.build",
    "ros.ament_python": "colcon.colcon_ros.task.ament_python.build",
}
_CMAKE_LOGGER = "colcon.colcon_cmake.task.cmake.build"


def find_task(package: Package) -> Task | None:
    """Return the task that builds a package, None if its build type is unknown."""
    task = _TASKS.get(package.type)
    return None if task is None else partial(_build_if_possible, task)


def _build_if_possible(task: Task, package: Package, settings: BuildSettings, work: Work) -> int:
    """Build a package unless a workspace package it needs was never built; returns an exit status."""
    missing = {
        name: script
        for name in settings.needs.get(package.name, ())
        if not (script := settings.prefix(name) / "share" / name / "package.sh").is_file()
        and not _is_underneath(name, settings)
    }
    if not missing:
        return task(package, settings, work)
    files = "".join(f"\n- {script}" for script in missing.values())
    names = "".join(f"\n- {name}" for name in missing)
    settings.warn(
        _LOGGERS.get(package.type, _CMAKE_LOGGER),
        f"Failed to find the following files:{files}\nCheck that the following packages have been built:{names}",
        "ERROR",
    )
    return 1


def refuse_foreign_folder(folder: Path) -> None:
    """Refuse a package's build folder that no build has filled: it has a student's own files, or other sources.

    Raises:
        NotOurs: nothing in the folder comes from a build.
    """
    try:
        names = os.listdir(folder)
    except (FileNotFoundError, NotADirectoryError):
        return
    if names and not any(name.startswith(_LEFT_BY_BUILDS) for name in names):
        raise NotOurOutput(
            f"'{folder}' exists already and was not made by colcon: move it away, or choose another folder with --build-base"
        )


def _is_underneath(name: str, settings: BuildSettings) -> bool:
    """Return whether a workspace that was sourced before has the package."""
    prefixes = settings.environment.get("AMENT_PREFIX_PATH", "").split(os.pathsep)
    return any(Path(prefix, "share", name, "package.sh").is_file() for prefix in prefixes if prefix)
