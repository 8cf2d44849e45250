"""Versions of extension points, and the classes that entry points name."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any

PLUGIN_SYSTEM_VERSION = "0.1"

_instances: dict[Any, Any] = {}


class PluginException(Exception):
    """Something is wrong with an extension."""


def instantiate_extensions(
    group_name: str, *, exclude_names: Collection[str] | None = None, unique_instance: bool = False
) -> dict[str, Any]:
    """Return an instance of each extension of a group, by name; those that do not fit are logged and left out."""
    import logging

    from ros2cli.entry_points import load_entry_points

    found = {}
    for name, kind in load_entry_points(group_name, exclude_names=exclude_names).items():
        if not unique_instance and kind in _instances:
            found[name] = _instances[kind]
            continue
        try:
            made = kind()
        except PluginException as error:
            logging.getLogger(__name__).warning(
                "Failed to instantiate '%s' extension '%s': %s", group_name, name, error
            )
            continue
        made.NAME = name
        found[name] = made
        if not unique_instance:
            _instances[kind] = made
    return found


def order_extensions(
    extensions: dict[str, Any], key_function: Callable[[Any], Any], *, reverse: bool = False
) -> dict[str, Any]:
    """Return extensions in the order of a key, then of their names."""
    return dict(sorted(extensions.items(), key=lambda row: (key_function(row[1]), row[0]), reverse=reverse))


def order_extensions_by_name(extensions: dict[str, Any]) -> dict[str, Any]:
    """Return extensions in the order of their names."""
    return dict(sorted(extensions.items()))


def satisfies_version(version: str, caret_range: str) -> None:
    """Raise PluginException unless a version is in a range like '^1.2' (the same major one; below 1, the same minor one)."""
    if not caret_range.startswith("^"):
        raise PluginException("satisfies_version() currently only supports '^' ranges")
    from packaging.version import Version

    lowest, upper = caret_range[1:], get_upper_bound_caret_version(caret_range[1:])
    if not Version(lowest) <= Version(version) < Version(upper):
        raise PluginException(f"version '{version}' is not in range [{lowest}, {upper})")


def get_upper_bound_caret_version(version: str) -> str:
    """Return the lowest version that is no longer compatible with this one."""
    from packaging.version import Version

    major, minor, micro = Version(version).release[0], *[*Version(version).release[1:3], 0, 0][:2]
    if major:
        return f"{major + 1}.0.0"
    return f"0.{minor + 1}.0" if minor else f"0.0.{micro + 1}"
