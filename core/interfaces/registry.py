"""Finds interface texts on the search path and keeps the classes made of them.

The search path is this simulator's own `core/ros/share`, then `share` of every prefix in AMENT_PREFIX_PATH, in order.
"""

from __future__ import annotations

import os
import sys
from _thread import RLock

from day6_tui.core.interfaces.definition import Structure, is_package_name, parse_action, parse_message, parse_service
from day6_tui.core.interfaces.generate import InterfaceType, build_message
from day6_tui.core.interfaces.services import build_action, build_service

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

KINDS = ("msg", "srv", "action")
_LIGHT = 80
OWN_SHARE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "ros", "share")

# Endings of the names of parts, longest first: 'Fibonacci_SendGoal_Request' is a part of 'Fibonacci'.
_PART_SUFFIXES = {
    "srv": ("_Request", "_Response", "_Event"),
    "action": (
        "_SendGoal_Request", "_SendGoal_Response", "_SendGoal_Event", "_SendGoal",
        "_GetResult_Request", "_GetResult_Response", "_GetResult_Event", "_GetResult",
        "_FeedbackMessage", "_Goal", "_Result", "_Feedback",
    ),
}  # fmt: skip

hashes: dict[str, str] = {}
"""Type hashes by full name; `hashing` fills it, `forget` empties it."""

_structures: dict[str, Structure] = {}
_classes: dict[str, Any] = {}
_more_prefixes: list[str] = []
# Classes are asked for by threads of programs, of the link and of windows.
_lock = RLock()
_building: list[str] = []


class InterfaceNameError(ValueError):
    """A name is not of the form 'package/msg/Name' (or srv, action), or of another kind than asked for."""


class UnknownInterfaceError(LookupError):
    """No text of that name is on the search path.

    `interface` is the full name; `package_known` says whether at least its package exists.
    """

    def __init__(self, interface: str, package_known: bool) -> None:
        package = interface.partition("/")[0]
        reason = f"package '{package}' has no such interface" if package_known else f"package '{package}' not found"
        super().__init__(f"unknown interface '{interface}': {reason}")
        self.interface = interface
        self.package_known = package_known


def add_prefixes(prefixes: list[str]) -> None:
    """Search these prefixes too (their `share` folders), after those of AMENT_PREFIX_PATH; the last ones added come first.

    For a process whose programs have environments of their own, like the workspace a simulated terminal has sourced.
    """
    if _more_prefixes[: len(prefixes)] != prefixes:
        _more_prefixes[:] = [*prefixes, *(prefix for prefix in _more_prefixes if prefix not in prefixes)]
        forget("")


def share_folders() -> list[str]:
    """Return the folders that hold packages' share folders, first wins."""
    prefixes = [*os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep), *_more_prefixes]
    return [OWN_SHARE, *(os.path.join(prefix, "share") for prefix in prefixes if prefix)]


def package_folder(package: str) -> str | None:
    """Return the share folder of a package with interfaces, None where there is none."""
    if not package or not is_package_name(package):
        return None
    for share in share_folders():
        folder = os.path.join(share, package)
        if any(os.path.isdir(os.path.join(folder, kind)) for kind in KINDS):
            return folder
    return None


def packages() -> list[str]:
    """Return the names of all packages with interfaces, sorted."""
    found: set[str] = set()
    for share in share_folders():
        if os.path.isdir(share):
            found.update(name for name in os.listdir(share) if package_folder(name))
    return sorted(found)


def interface_names(package: str, kind: str | None = None) -> list[str]:
    """Return 'msg/String'-like names of a package's interfaces, by kind (msg, srv, action) and then name.

    Empty for an unknown package.
    """
    folder = package_folder(package)
    names: list[str] = []
    for each in KINDS if kind is None else (kind,):
        inner = os.path.join(folder, each) if folder else ""
        if inner and os.path.isdir(inner):
            files = (file for file in os.listdir(inner) if file.endswith(f".{each}"))
            names += sorted(f"{each}/{file.rpartition('.')[0]}" for file in files)
    return names


def split_name(name: str) -> tuple[str, str, str]:
    """Split 'std_msgs/msg/String'. Raises InterfaceNameError."""
    parts = name.split("/") if isinstance(name, str) else []
    if len(parts) != 3 or parts[1] not in KINDS or not all(parts):
        raise InterfaceNameError(f"'{name}' is not the full name of an interface, like 'std_msgs/msg/String'")
    return parts[0], parts[1], parts[2]


def definition_path(name: str) -> str:
    """Return the file with the text of an interface. Raises InterfaceNameError or UnknownInterfaceError."""
    package, kind, base = split_name(name)
    folder = package_folder(package)
    # Compared with the listing, because some file systems find String.msg under the name string.msg.
    if folder is None or f"{kind}/{base}" not in interface_names(package, kind):
        raise UnknownInterfaceError(name, folder is not None)
    return os.path.join(folder, kind, f"{base}.{kind}")


def definition_text(name: str) -> str:
    """Return the .msg, .srv or .action text of 'std_msgs/msg/String'. Raises as `definition_path`."""
    with open(definition_path(name), encoding="utf-8") as file:
        return file.read()


def base_name(name: str) -> str:
    """Return the interface whose text holds a part: 'p/srv/Foo' for 'p/srv/Foo_Request'."""
    package, kind, part = split_name(name)
    for suffix in _PART_SUFFIXES.get(kind, ()):
        if part.endswith(suffix):
            return f"{package}/{kind}/{part.removesuffix(suffix)}"
    return name


def structure(name: str) -> Structure:
    """Return the structure of a message or of a part of a service or action ('std_srvs/srv/SetBool_Request').

    Raises InterfaceNameError, UnknownInterfaceError, or what the parser raises for a bad text.
    """
    known = _structures.get(name)
    if known is None:
        base = base_name(name)
        package, kind, own = split_name(base)
        text = definition_text(base)
        if kind == "msg":
            _structures[name] = parse_message(package, kind, own, text)
        else:
            parse = parse_service if kind == "srv" else parse_action
            _structures.update((part.full_name, part) for part in parse(package, kind, own, text))
        known = _structures.get(name)
        if known is None:
            raise UnknownInterfaceError(name, True)
    return known


def is_light(name: str) -> bool:
    """Say whether a message is small enough that generated code handles it in place instead of calling its own function."""
    return weigh(structure(name)) <= _LIGHT


def weigh(counted: Structure) -> int:
    """Return how many values a structure holds, those of messages inside included (sequences count once)."""
    if not counted.weight:
        nested = [weigh(structure(field.type.base)) for field in counted.fields if field.type.nested]
        counted.weight = 1 + len(counted.fields) + sum(nested)
    return counted.weight


def find_class(name: str) -> Any:
    """Return the class of a message, service, action or part of one by its full name; made on first use, then kept."""
    known = _classes.get(name)
    if known is not None:
        return known
    with _lock:
        if name in _building:
            raise InterfaceNameError(f"'{name}' contains itself: {' > '.join([*_building, name])}")
        _building.append(name)
        try:
            return _classes.get(name) or _classes.setdefault(name, _build(name))
        finally:
            _building.pop()


def _build(name: str) -> type:
    package, kind, own = split_name(name)
    if kind == "srv" and base_name(name) == name:
        definition_path(name)
        return build_service(package, kind, own, find_class)
    if kind == "action" and own.endswith(("_SendGoal", "_GetResult")):
        definition_path(base_name(name))
        return build_service(package, kind, own, find_class)
    if kind == "action" and base_name(name) == name:
        definition_path(name)
        return build_action(package, own, find_class)
    return build_message(structure(name), find_class)


def forget(package: str) -> None:
    """Drop what is known of a package whose texts were built anew, and of all others outside this simulator's own.

    (They may contain its messages.) Classes handed out before live on unchanged.
    """
    own = set(os.listdir(OWN_SHARE)) - {package}
    with _lock:
        for store in (_structures, _classes, hashes):
            for name in [name for name in store if name.partition("/")[0] not in own]:
                del store[name]
    for module_name, module in list(sys.modules.items()):
        name, _, kind = module_name.partition(".")
        if kind.partition(".")[0] in KINDS and name not in own:
            for key in [key for key, value in vars(module).items() if isinstance(value, InterfaceType)]:
                delattr(module, key)


def get_interface(name: str) -> Any:
    """Return the class of 'std_msgs/msg/String', 'std_srvs/srv/SetBool' or 'example_interfaces/action/Fibonacci'.

    Raises InterfaceNameError (a ValueError) for a malformed name, UnknownInterfaceError (a LookupError) where no such
    text exists, and the parser's errors for a text that breaks the rules.
    """
    return find_class(name)


def get_message(name: str) -> Any:
    """Return the class of a message; raises as `get_interface`, and InterfaceNameError for a service or action."""
    return _get_kind(name, "msg", "a message")


def get_service(name: str) -> Any:
    """Return the class of a service; raises as `get_interface`, and InterfaceNameError for a message or action."""
    return _get_kind(name, "srv", "a service")


def get_action(name: str) -> Any:
    """Return the class of an action; raises as `get_interface`, and InterfaceNameError for a message or service."""
    return _get_kind(name, "action", "an action")


def _get_kind(name: str, kind: str, word: str) -> Any:
    if split_name(name)[1] != kind:
        raise InterfaceNameError(f"'{name}' is not the full name of {word}, like 'package/{kind}/Name'")
    return find_class(name)


def type_name(cls: Any) -> str:
    """Return 'std_msgs/msg/String' for a message, service or action class. Raises TypeError for anything else."""
    if isinstance(cls, InterfaceType):
        return cls._interface_name
    raise TypeError(f"{cls!r} is not the class of a message, service or action")
