"""Finds interface texts on the search path and keeps the classes generated from them.

The search path is our own `day6_core/ros/share`, then `share` of every prefix in AMENT_PREFIX_PATH, in order. Of ours there is
what the process's distribution has, in its words.
"""

from __future__ import annotations

import os
import sys
from _thread import RLock

from day6_core.interfaces.definition import Structure, is_package_name, parse_action, parse_message, parse_service
from day6_core.interfaces.generate import InterfaceType, build_message
from day6_core.interfaces.services import build_action, build_service
from day6_core.ros import differences

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

KINDS = ("msg", "srv", "action")
_LIGHT = 80
OWN_SHARE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "ros", "share")

# Suffixes of the names of parts, longest first: 'Fibonacci_SendGoal_Request' is a part of 'Fibonacci'.
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
# Threads of programs, of the link and of windows look up classes.
_lock = RLock()
_building: list[str] = []


class InterfaceNameError(ValueError):
    """A name is not of the form 'package/msg/Name' (or srv, action), or not of the expected kind."""


class UnknownInterfaceError(LookupError):
    """There is no text of that name on the search path.

    `interface` is the full name; `package_known` is whether at least its package exists.
    """

    def __init__(self, interface: str, package_known: bool) -> None:
        package = interface.partition("/")[0]
        reason = f"package '{package}' has no such interface" if package_known else f"package '{package}' not found"
        super().__init__(f"unknown interface '{interface}': {reason}")
        self.interface = interface
        self.package_known = package_known


def add_prefixes(prefixes: list[str]) -> None:
    """Also search the `share` folders of these prefixes, after those of AMENT_PREFIX_PATH; the last ones added come first.

    For a process whose programs have separate environments, like a workspace sourced in a simulated terminal.
    """
    if _more_prefixes[: len(prefixes)] != prefixes:
        _more_prefixes[:] = [*prefixes, *(prefix for prefix in _more_prefixes if prefix not in prefixes)]
        forget("")


def share_folders() -> list[str]:
    """Return the folders that contain packages' share folders; the first has precedence."""
    prefixes = [*os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep), *_more_prefixes]
    return [OWN_SHARE, *(os.path.join(prefix, "share") for prefix in prefixes if prefix)]


def package_folder(package: str) -> str | None:
    """Return the share folder of a package with interfaces, None if there is no such package."""
    if not package or not is_package_name(package):
        return None
    for share in share_folders():
        folder = os.path.join(share, package)
        if share is OWN_SHARE and not differences.has_interface(package):
            continue
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
            found = {f"{each}/{file.rpartition('.')[0]}" for file in files}
            if folder is not None and _is_ours(folder):
                found.update(name for name in differences.own_texts(package) if name.startswith(f"{each}/"))
                found = {name for name in found if differences.has_interface(f"{package}/{name}")}
            names += sorted(found)
    return names


def _is_ours(folder: str) -> bool:
    return os.path.dirname(folder) == OWN_SHARE


def split_name(name: str) -> tuple[str, str, str]:
    """Split 'std_msgs/msg/String' into package, kind and name.

    Raises:
        InterfaceNameError: the name is malformed.
    """
    parts = name.split("/") if isinstance(name, str) else []
    if len(parts) != 3 or parts[1] not in KINDS or not all(parts):
        raise InterfaceNameError(f"'{name}' is not the full name of an interface, like 'std_msgs/msg/String'")
    return parts[0], parts[1], parts[2]


def definition_path(name: str) -> str:
    """Return the path of the file with the text of an interface.

    Raises:
        InterfaceNameError, UnknownInterfaceError: the name is malformed, or there is no such interface.
    """
    package, kind, base = split_name(name)
    folder = package_folder(package)
    # Compared with the listing, because some file systems find String.msg under the name string.msg.
    if folder is None or f"{kind}/{base}" not in interface_names(package, kind):
        raise UnknownInterfaceError(name, folder is not None)
    return differences.path_of(name, OWN_SHARE) if _is_ours(folder) else os.path.join(folder, kind, f"{base}.{kind}")


def definition_text(name: str) -> str:
    """Return the .msg, .srv or .action text of 'std_msgs/msg/String'; raises the errors of `definition_path`."""
    with open(definition_path(name), encoding="utf-8") as file:
        return file.read()


def base_name(name: str) -> str:
    """Return the interface whose text contains a part: 'p/srv/Foo' for 'p/srv/Foo_Request'."""
    package, kind, part = split_name(name)
    for suffix in _PART_SUFFIXES.get(kind, ()):
        if part.endswith(suffix):
            return f"{package}/{kind}/{part.removesuffix(suffix)}"
    return name


def structure(name: str) -> Structure:
    """Return the structure of a message or of a part of a service or action ('std_srvs/srv/SetBool_Request').

    Raises:
        InterfaceNameError, UnknownInterfaceError: the name is malformed, or there is no such interface.
        InvalidSpecification, InvalidValue, NameError, TypeError, ValueError: the text is invalid.
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
    """Return whether a message is small enough that generated code handles it inline instead of calling its function."""
    return count_values(structure(name)) <= _LIGHT


def count_values(counted: Structure) -> int:
    """Return the number of values in a structure, including those of nested messages (a sequence counts once)."""
    if not counted.value_count:
        nested = [count_values(structure(field.type.base)) for field in counted.fields if field.type.nested]
        counted.value_count = 1 + len(counted.fields) + sum(nested)
    return counted.value_count


def find_class(name: str) -> Any:
    """Return the class of a message, service, action or part of one by its full name; generated on first use.

    Raises:
        InterfaceNameError, UnknownInterfaceError: the name is malformed, contains itself, or there is no such interface.
        InvalidSpecification, InvalidValue, NameError, TypeError, ValueError: the text is invalid.
    """
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
    """Drop the classes of a rebuilt package, and of all other packages except our own, which may use its messages.

    Ours come first (`share_folders`), so nothing changes them: not even a workspace with a package of the same name. Classes
    returned before stay valid and unchanged.
    """
    own = {name for name in os.listdir(OWN_SHARE) if name != package or differences.has_interface(name)}
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

    Raises:
        InterfaceNameError: (a ValueError) the name is malformed.
        UnknownInterfaceError: (a LookupError) there is no such text.
        InvalidSpecification, InvalidValue, NameError, TypeError, ValueError: the text is invalid.
    """
    return find_class(name)


def get_message(name: str) -> Any:
    """Return the class of a message; raises the errors of `get_interface`, and InterfaceNameError for another kind."""
    return _get_kind(name, "msg", "a message")


def get_service(name: str) -> Any:
    """Return the class of a service; raises the errors of `get_interface`, and InterfaceNameError for another kind."""
    return _get_kind(name, "srv", "a service")


def get_action(name: str) -> Any:
    """Return the class of an action; raises the errors of `get_interface`, and InterfaceNameError for another kind."""
    return _get_kind(name, "action", "an action")


def _get_kind(name: str, kind: str, word: str) -> Any:
    if split_name(name)[1] != kind:
        raise InterfaceNameError(f"'{name}' is not the full name of {word}, like 'package/{kind}/Name'")
    return find_class(name)


def type_name(cls: Any) -> str:
    """Return 'std_msgs/msg/String' for a message, service or action class.

    Raises:
        TypeError: for anything else.
    """
    if isinstance(cls, InterfaceType):
        return cls._interface_name
    raise TypeError(f"{cls!r} is not the class of a message, service or action")


def message_class(cls: Any) -> Any:
    """Return the generated class of a message class, also of one a program derived from it.

    Raises:
        TypeError: `cls` is not a message class.
    """
    name = type_name(cls)
    generated = next(base for base in reversed(cls.__mro__[:-1]) if getattr(base, "_interface_name", "") == name)
    if generated._structure is None:
        raise TypeError(f"{cls!r} is not the class of a message")
    return generated
