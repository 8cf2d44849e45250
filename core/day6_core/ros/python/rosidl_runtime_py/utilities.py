"""Interface classes by name (`std_msgs/msg/String`; in the three specific functions also `std_msgs/String`)."""

from __future__ import annotations

from importlib import import_module
from typing import Any, NamedTuple


class _Name(NamedTuple):
    """The part of a type description that `import_message` needs."""

    namespaces: list[str]
    name: str


def get_interface(identifier: str) -> Any:
    """Return the class of a message, service or action by its full name.

    Raises ValueError for a malformed name, ModuleNotFoundError for an unknown package, AttributeError for an unknown type.
    """
    return _imported(_parts(identifier, None))


def get_message(identifier: str) -> Any:
    """Return a message class. Raises the errors of `get_interface`, and ValueError if it isn't a message."""
    found = _imported(_parts(identifier, "msg"))
    if not is_message(found):
        raise ValueError(f"Expected the full name of a message, got '{identifier}'")
    return found


def get_service(identifier: str) -> Any:
    """Return a service class. Raises the errors of `get_interface`, and ValueError if it isn't a service."""
    found = _imported(_parts(identifier, "srv"))
    if not is_service(found):
        raise ValueError(f"Expected the full name of a service, got '{identifier}'")
    return found


def get_action(identifier: str) -> Any:
    """Return an action class. Raises the errors of `get_interface`, and ValueError if it isn't an action."""
    found = _imported(_parts(identifier, "action"))
    if not is_action(found):
        raise ValueError(f"Expected the full name of an action, got '{identifier}'")
    return found


def get_namespaced_type(identifier: str) -> Any:
    """Return the `NamespacedType` of a full name."""
    return _namespaced(identifier, None)


def get_message_namespaced_type(identifier: str) -> Any:
    """Return the `NamespacedType` of a message's name."""
    return _namespaced(identifier, "msg")


def get_service_namespaced_type(identifier: str) -> Any:
    """Return the `NamespacedType` of a service's name."""
    return _namespaced(identifier, "srv")


def get_action_namespaced_type(identifier: str) -> Any:
    """Return the `NamespacedType` of an action's name."""
    return _namespaced(identifier, "action")


def is_message(interface: Any) -> bool:
    """Return whether a class is a message."""
    return hasattr(interface, "SLOT_TYPES")


def is_service(interface: Any) -> bool:
    """Return whether a class is a service."""
    return hasattr(interface, "Request") and hasattr(interface, "Response")


def is_action(interface: Any) -> bool:
    """Return whether a class is an action."""
    return all(hasattr(interface, part) for part in ("Goal", "Result", "Feedback"))


def _parts(identifier: str, default_kind: str | None) -> _Name:
    *namespaces, name = identifier.split("/")
    if len(namespaces) == 1 and default_kind is not None:
        namespaces.append(default_kind)
    return _Name(namespaces, name)


def _imported(parts: _Name) -> Any:
    from rosidl_runtime_py.import_message import import_message_from_namespaced_type

    package = ".".join(parts.namespaces)
    if package.startswith("."):
        raise TypeError(f"the 'package' argument is required to perform a relative import for '{package}'")
    if parts.namespaces and not all(part.isidentifier() for part in parts.namespaces):
        # `import_module` would give '..x' and dotted names their meaning in Python.
        raise ModuleNotFoundError(f"No module named {package!r}")
    return import_message_from_namespaced_type(parts)


def _namespaced(identifier: str, default_kind: str | None) -> Any:
    parts = _parts(identifier, default_kind)
    return import_module("rosidl_parser.definition").NamespacedType(parts.namespaces, parts.name)
