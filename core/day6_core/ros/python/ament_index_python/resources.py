"""The resource index: files `share/ament_index/resource_index/<type>/<name>` below every prefix.

The packages of day6-tui have no such files of the types `packages` and `rosidl_interfaces`; they are found by their package.xml
and by the definitions of their interfaces.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

from ament_index_python.constants import RESOURCE_INDEX_SUBFOLDER
from ament_index_python.search_paths import BUILT_IN_PREFIX, get_search_paths
from day6_core.ros.differences import has_interface, own_texts
from day6_core.ros.environment import shipped_packages

_PACKAGES, _INTERFACES = "packages", "rosidl_interfaces"


class InvalidResourceTypeNameError(ValueError):
    """Raised for a resource type that contains a path separator."""


class InvalidResourceNameError(ValueError):
    """Raised for a resource name that contains a path separator."""


def get_resource(resource_type: str, resource_name: str) -> tuple[str, str]:
    """Return (content, prefix) of a resource.

    Raises LookupError if there is none, OSError if it can't be read, AssertionError for an empty and
    InvalidResource(Type)NameError for an invalid name.
    """
    prefix = has_resource(resource_type, resource_name)
    if not prefix:
        raise LookupError(f"Could not find the resource '{resource_name}' of type '{resource_type}'")
    file = Path(prefix, RESOURCE_INDEX_SUBFOLDER, resource_type, resource_name)
    if _is_ours(prefix, resource_type) and not file.is_file():
        interfaces = shipped_interfaces(resource_name) if resource_type == _INTERFACES else []
        return "\n".join(f"{name}.{name.partition('/')[0]}" for name in interfaces), prefix
    try:
        return file.read_text(encoding="utf-8"), prefix
    except OSError as error:
        problem = f"Could not open the resource '{resource_name}' of type '{resource_type}':\n{error}"
        raise OSError(problem) from error


def get_resources(resource_type: str) -> dict[str, str]:
    """Return `{name: prefix}` of all resources of a type; if two prefixes have one, the first wins.

    Raises AssertionError for an empty and InvalidResourceTypeNameError for an invalid type.
    """
    _check_type(resource_type)
    found: dict[str, str] = {}
    for prefix in get_search_paths():
        for name in names_in(prefix, resource_type):
            found.setdefault(name, prefix)
    return found


def get_resource_types() -> set[str]:
    """Return the types of all resources."""
    found = {_PACKAGES, _INTERFACES}
    for prefix in get_search_paths():
        index = Path(prefix, RESOURCE_INDEX_SUBFOLDER)
        if index.is_dir():
            found.update(folder.name for folder in index.iterdir() if folder.is_dir() and folder.name[0] != ".")
    return found


def has_resource(resource_type: str, resource_name: str) -> str | Literal[False]:
    """Return the prefix of a resource, False if there is none.

    Raises AssertionError for an empty and InvalidResource(Type)NameError for an invalid name.
    """
    _check_type(resource_type)
    assert resource_name, "The resource name must not be empty"
    if _is_invalid_name(resource_name):
        raise InvalidResourceNameError(f"Resource name '{resource_name}' is invalid")
    return next((prefix for prefix in get_search_paths() if resource_name in names_in(prefix, resource_type)), False)


def _check_type(resource_type: str) -> None:
    assert resource_type, "The resource type must not be empty"
    if _is_invalid_name(resource_type):
        raise InvalidResourceTypeNameError(f"Resource type '{resource_type}' is invalid")


def _is_invalid_name(name: str) -> bool:
    return "/" in name or "\\" in name


def _is_ours(prefix: str, resource_type: str) -> bool:
    return prefix == BUILT_IN_PREFIX and resource_type in (_PACKAGES, _INTERFACES)


def names_in(prefix: str, resource_type: str) -> Iterator[str]:
    """Yield the names of the resources of a type under one prefix, sorted."""
    if _is_ours(prefix, resource_type):
        packages = shipped_packages()
        yield from packages if resource_type == _PACKAGES else filter(shipped_interfaces, packages)
        return
    folder = Path(prefix, RESOURCE_INDEX_SUBFOLDER, resource_type)
    if folder.is_dir():
        yield from sorted(name for name in os.listdir(folder) if name[0] != "." and not (folder / name).is_dir())


def shipped_interfaces(package: str) -> list[str]:
    """Return the interfaces of a package that comes with day6-tui, sorted, like 'msg/String'."""
    share = Path(BUILT_IN_PREFIX, "share", package)
    names = {f"{kind}/{path.stem}" for kind in ("action", "msg", "srv") for path in (share / kind).glob(f"*.{kind}")}
    return sorted(name for name in {*names, *own_texts(package)} if has_interface(f"{package}/{name}"))
