"""Looks up interfaces by name, prints messages, and fills them from plain values, for ROS tools.

The public names are those of the package in a ROS installation; they are loaded on first access (PEP 562), so that a
tool that only looks up a class does not pay for printing. It imports only ament_index_python and message packages;
`ros2` and tools such as rqt import it.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

# Not lazy: one function has the name of its module, and the function must win.
from rosidl_runtime_py.get_interfaces import (
    get_action_interfaces,
    get_interface_packages,
    get_interface_path,
    get_interfaces,
    get_message_interfaces,
    get_service_interfaces,
)

_HOMES = {
    "get_message_slot_types": "convert",
    "import_message_from_namespaced_type": "import_message",
    "message_to_csv": "convert",
    "message_to_ordereddict": "convert",
    "message_to_yaml": "convert",
    "set_message_fields": "set_message",
}

__all__ = [
    "get_action_interfaces",
    "get_interface_packages",
    "get_interface_path",
    "get_interfaces",
    "get_message_interfaces",
    "get_message_slot_types",
    "get_service_interfaces",
    "import_message_from_namespaced_type",
    "message_to_csv",
    "message_to_ordereddict",
    "message_to_yaml",
    "set_message_fields",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value
