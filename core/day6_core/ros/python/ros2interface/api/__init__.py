"""Interfaces by their names."""

from __future__ import annotations

import os
from typing import Any

from rosidl_runtime_py import get_interface_packages, message_to_yaml, utilities

from day6_core.ros.ros2.interface.list import interface_names


def package_name_completer(**kwargs: Any) -> Any:
    """Complete the name of a package with interfaces."""
    return get_interface_packages()


def type_completer(**kwargs: Any) -> list[str]:
    """Complete the type of an interface."""
    return interface_names(os.environ)


def interface_to_yaml(identifier: str) -> str:
    """Return a message, a request or a goal with its default values."""
    interface = utilities.get_interface(identifier)
    part = "Goal" if utilities.is_action(interface) else "Request" if utilities.is_service(interface) else None
    text: str = message_to_yaml(getattr(interface, part)() if part else interface())
    return text
