"""The registered component types: the resources `rclcpp_components` of the ament index."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from ament_index_python.search_paths import get_search_paths

if TYPE_CHECKING:
    from day6_core.ros.ros2.cli.completion import CompletionContext
    from day6_core.session.session import Session

_RESOURCES = Path("share", "ament_index", "resource_index", "rclcpp_components")


def packages_with_components(session: Session) -> list[str]:
    """Return the packages that register component types, sorted."""
    found: set[str] = set()
    for prefix in get_search_paths(session.env):
        folder = Path(prefix) / _RESOURCES
        if folder.is_dir():
            found.update(path.name for path in folder.iterdir())
    return sorted(found)


def component_types(session: Session, package: str) -> list[str]:
    """Return the component types of a package in the file's order; empty for a package that registers none."""
    return [line.partition(";")[0] for line in resource_lines(session, package)]


def resource_lines(session: Session, package: str) -> list[str]:
    """Return the lines `TYPE;LIBRARY` that a package registers; the first prefix that has the package wins."""
    for prefix in get_search_paths(session.env):
        file = Path(prefix) / _RESOURCES / package
        if package and file.is_file():
            return [line for line in file.read_text(encoding="utf-8").splitlines() if line]
    return []


def package_names(context: CompletionContext) -> Iterable[str]:
    """Complete a package that registers components."""
    return packages_with_components(context.session)


def type_names(context: CompletionContext) -> Iterable[str]:
    """Complete a component type of the package named before."""
    return component_types(context.session, context.values.get("package_name", ""))
