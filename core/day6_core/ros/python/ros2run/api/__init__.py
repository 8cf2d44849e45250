"""Finding and running a package's executable."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ros2pkg.api import PackageNotFound, get_executable_paths

from day6_core.ros.program_index import named_by

ROS2RUN_MSG_PREFIX = "[ros2run]:"


class MultipleExecutables(Exception):
    """A package has several executables of one name, in `paths`."""

    def __init__(self, paths: Sequence[str]) -> None:
        super().__init__(paths)
        self.paths = paths


def get_executable_path(*, package_name: str, executable_name: str) -> str | None:
    """Return the path of an executable, None if the package has none of this name."""
    paths = [
        path for path in get_executable_paths(package_name=package_name) if os.path.basename(path) == executable_name
    ]
    if len(paths) > 1:
        raise MultipleExecutables(paths)
    return paths[0] if paths else None


def run_executable(*, path: str, argv: Sequence[str], prefix: Sequence[str] | None = None) -> int:
    """Run it as a process, print how it failed if it did, and return its status."""
    ours = named_by(Path(path))  # it is no file
    process = subprocess.Popen([*(prefix or []), *(["ros2", "run", *ours] if ours else [path]), *argv])
    while process.returncode is None:
        try:
            process.communicate()
        except KeyboardInterrupt:
            continue  # the process has got it too
    if process.returncode:
        from day6_core.session.signals import TEXTS

        print(ROS2RUN_MSG_PREFIX, TEXTS.get(-process.returncode) or f"Process exited with failure {process.returncode}")
    return process.returncode


class ExecutableNameCompleter:
    """Completes the name of an executable of the package that was named."""

    def __init__(self, *, package_name_key: str | None = None) -> None:
        self.package_name_key = package_name_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        try:
            paths = get_executable_paths(package_name=getattr(parsed_args, self.package_name_key or ""))
        except PackageNotFound:
            return []
        return [os.path.basename(path) for path in paths]
