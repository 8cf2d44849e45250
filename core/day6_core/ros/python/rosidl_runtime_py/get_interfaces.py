"""Lists the interfaces on the search path and finds their definitions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from ament_index_python.packages import get_packages_with_prefixes
from ament_index_python.resources import shipped_interfaces
from ament_index_python.search_paths import BUILT_IN_PREFIX

from day6_core.ros.differences import has_interface, path_of

_KINDS = ("msg", "srv", "action")

Environment = Mapping[str, str] | None
"""The mapping that replaces `os.environ`."""


def get_interface_packages(environment: Environment = None) -> dict[str, str]:
    """Return `{package: prefix}` of the packages that define interfaces."""
    prefixes = get_packages_with_prefixes(environment)
    return {name: prefix for name, prefix in prefixes.items() if _definitions(Path(prefix), name, _KINDS)}


def get_interfaces(package_names: Iterable[str] = (), environment: Environment = None) -> dict[str, list[str]]:
    """Return `{package: ['msg/String', …]}` of some packages or of all. Raises LookupError for an unknown package."""
    return _interfaces(package_names, _KINDS, environment)


def get_message_interfaces(package_names: Iterable[str] = (), environment: Environment = None) -> dict[str, list[str]]:
    """Like `get_interfaces`, for messages only."""
    return _interfaces(package_names, ("msg",), environment)


def get_service_interfaces(package_names: Iterable[str] = (), environment: Environment = None) -> dict[str, list[str]]:
    """Like `get_interfaces`, for services only."""
    return _interfaces(package_names, ("srv",), environment)


def get_action_interfaces(package_names: Iterable[str] = (), environment: Environment = None) -> dict[str, list[str]]:
    """Like `get_interfaces`, for actions only."""
    return _interfaces(package_names, ("action",), environment)


def get_interface_path(interface_name: str, environment: Environment = None) -> str:
    """Return the file that defines `package/kind/Name` (a suffix may be given).

    Raises ValueError for a malformed name, LookupError for an unknown package or interface.
    """
    parts = interface_name.split("/")
    if len(parts) < 2:
        raise ValueError(f"Invalid name '{interface_name}'. Expected at least two parts separated by '/'")
    if not all(parts):
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain empty parts")
    if ".." in parts:
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain '..'")
    prefix = get_packages_with_prefixes(environment).get(parts[0])
    if prefix is None:
        raise LookupError(f"Unknown package '{parts[0]}'")
    if prefix == BUILT_IN_PREFIX and len(parts) == 3:
        stem, _, suffix = parts[2].partition(".")
        own = Path(path_of("/".join((*parts[:2], stem)), str(Path(prefix, "share"))))
        if suffix in ("", parts[1]) and own.is_file() and has_interface("/".join((*parts[:2], stem))):
            return str(own)
        raise LookupError(f"Could not find the interface '{own.with_suffix('.idl')}'")
    path = Path(prefix, "share", *parts)
    if "." in parts[-1]:
        candidates = [path]
    else:
        candidates = [path.with_name(f"{parts[-1]}.{parts[-2]}"), path.with_name(f"{parts[-1]}.idl")]
    for candidate in candidates:
        if candidate.exists():
            return str(candidate)
    raise LookupError(f"Could not find the interface '{candidates[-1]}'")


def _interfaces(package_names: Iterable[str], kinds: tuple[str, ...], environment: Environment) -> dict[str, list[str]]:
    prefixes = get_packages_with_prefixes(environment)
    found: dict[str, list[str]] = {}
    for name in list(package_names) or prefixes:
        if name not in prefixes:
            raise LookupError(f"Unknown package '{name}'")
        definitions = _definitions(Path(prefixes[name]), name, kinds)
        if definitions:
            found[name] = definitions
    return found


def _definitions(prefix: Path, package: str, kinds: tuple[str, ...]) -> list[str]:
    if str(prefix) == BUILT_IN_PREFIX:
        return [name for name in shipped_interfaces(package) if name.partition("/")[0] in kinds]
    names = set()
    for kind in kinds:
        for path in (prefix / "share" / package / kind).glob("*"):
            # Names with an underscore are parts of services and actions, not interfaces of their own.
            if path.suffix in (f".{kind}", ".idl") and "_" not in path.stem:
                names.add(f"{kind}/{path.stem}")
    return sorted(names)
