"""The installed packages and their prefixes."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path

from ament_index_python.constants import RESOURCE_INDEX_SUBFOLDER
from ament_index_python.resources import names_in
from ament_index_python.search_paths import BUILT_IN_PREFIX, get_search_paths
from day6_core.ros.differences import has_package

_VALID_NAME = re.compile(r"[a-zA-Z0-9][a-zA-Z0-9_-]+")


class PackageNotFoundError(KeyError):
    """Raised for a package that isn't under any of the prefixes."""


def get_packages_with_prefixes(environment: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return `{package: prefix}`; if two prefixes have a package, the first wins."""
    found: dict[str, str] = {}
    for prefix in get_search_paths(environment):
        for name in names_in(prefix, "packages"):
            found.setdefault(name, prefix)
    return found


def get_package_prefix(package_name: str, environment: Mapping[str, str] | None = None) -> str:
    """Return the prefix of a package. Raises ValueError for an invalid name, PackageNotFoundError."""
    if not _VALID_NAME.fullmatch(package_name):
        raise ValueError(f"'{package_name}' is not a valid package name")
    paths = get_search_paths(environment)
    for prefix in paths:
        if _has_package(prefix, package_name):
            return prefix
    raise PackageNotFoundError(f"package '{package_name}' not found, searching: {paths}")


def get_package_share_directory(
    package_name: str, print_warning: bool = True, environment: Mapping[str, str] | None = None
) -> str:
    """Return `<prefix>/share/<package>`. Raises the same errors as `get_package_prefix`."""
    path = os.path.join(get_package_prefix(package_name, environment), "share", package_name)
    if print_warning and not os.path.exists(path):
        import warnings

        warnings.warn(f"Share directory for {package_name} ({path}) does not exist.", stacklevel=2)
    return path


def get_package_share_path(package_name: str, print_warning: bool = True) -> Path:
    """Like `get_package_share_directory`, as a Path."""
    return Path(get_package_share_directory(package_name, print_warning))


def _has_package(prefix: str, name: str) -> bool:
    if prefix == BUILT_IN_PREFIX:
        return has_package(name) and Path(prefix, "share", name, "package.xml").is_file()
    return Path(prefix, RESOURCE_INDEX_SUBFOLDER, "packages", name).is_file()
