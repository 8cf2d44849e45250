"""Entry points of installed packages."""

from __future__ import annotations

import logging
from collections.abc import Collection
from importlib.metadata import EntryPoint, entry_points
from typing import Any

EXTENSION_POINT_GROUP_NAME = "ros2cli.extension_point"


def get_entry_points(group_name: str) -> dict[str, EntryPoint]:
    """Return the entry points of a group by name."""
    return {each.name: each for each in entry_points(group=group_name)}


def load_entry_points(group_name: str, *, exclude_names: Collection[str] | None = None) -> dict[str, Any]:
    """Return what the entry points of a group name, by name; one that cannot be imported is logged and left out."""
    found = {}
    for name, point in get_entry_points(group_name).items():
        if name in (exclude_names or ()):
            continue
        try:
            found[name] = point.load()
        except Exception as error:
            logging.getLogger(__name__).warning("Failed to load entry point '%s': %s", name, error)
    return found


def get_first_line_doc(any_type: Any) -> str:
    """Return the first line of a docstring without its full stop; '' without one."""
    lines = [line.strip() for line in (any_type.__doc__ or "").splitlines() if line.strip()]
    return lines[0].rstrip(".") if lines else ""
