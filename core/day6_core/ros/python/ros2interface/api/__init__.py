"""Interfaces by their names."""

from __future__ import annotations

from typing import Any

from rosidl_runtime_py import (
    get_action_interfaces,
    get_interface_packages,
    get_message_interfaces,
    get_service_interfaces,
    message_to_yaml,
    utilities,
)


def package_name_completer(**kwargs: Any) -> Any:
    """Complete the name of a package with interfaces."""
    return get_interface_packages()


def type_completer(**kwargs: Any) -> list[str]:
    """Complete the type of an interface."""
    return sorted(
        f"{package}/{name}"
        for found in (get_service_interfaces(), get_message_interfaces(), get_action_interfaces())
        for package, names in found.items()
        for name in names
    )


def interface_to_yaml(identifier: str) -> str:
    """Return a message, a request or a goal with its default values."""
    interface = utilities.get_interface(identifier)
    part = "Goal" if utilities.is_action(interface) else "Request" if utilities.is_service(interface) else None
    text: str = message_to_yaml(getattr(interface, part)() if part else interface())
    return text
