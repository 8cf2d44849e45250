"""Packages and their executables."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

from ament_index_python.packages import PackageNotFoundError, get_package_prefix, get_packages_with_prefixes

from day6_core.ros.ros2.cli.packages import executables_in


class PackageNotFound(Exception):
    """There is no package with a name."""

    def __init__(self, package_name: str) -> None:
        super().__init__(package_name)
        self.package_name = package_name


def get_package_names() -> Iterable[str]:
    """Return the names of all packages."""
    return get_packages_with_prefixes().keys()


def get_prefix_path(package_name: str) -> str | None:
    """Return the prefix of a package, None if there is none with this name."""
    try:
        return get_package_prefix(package_name)
    except (PackageNotFoundError, ValueError):
        return None


def get_executable_paths(*, package_name: str) -> list[str]:
    """Return the paths of a package's executables. Raises PackageNotFound."""
    found = executables_in(os.environ, package_name)
    if found is None:
        raise PackageNotFound(package_name)
    return [str(each.path) for each in found]


def package_name_completer(**kwargs: Any) -> Iterable[str]:
    """Complete the name of a package."""
    return get_package_names()
