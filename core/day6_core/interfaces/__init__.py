"""Interface texts (.msg, .srv, .action) as Python classes like rosidl's, their CDR bytes and their type hashes.

Imports nothing else of day6-tui; everything else may import it. Classes are generated on first use; numpy is imported only
when a message with a fixed array of numbers is created. Packages of `day6_core/ros/python` call `package`; everything else uses
the functions exported here.
"""

from __future__ import annotations

from day6_core.interfaces.registry import (
    InterfaceNameError,
    UnknownInterfaceError,
    add_prefixes,
    definition_text,
    forget,
    get_action,
    get_interface,
    get_message,
    get_service,
    interface_names,
    packages,
    type_name,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from day6_core.interfaces.cdr import DeserializationError, SerializationError, deserialize, serialize
    from day6_core.interfaces.copying import copy_message
    from day6_core.interfaces.hashing import type_hash

__all__ = [
    "DeserializationError",
    "InterfaceNameError",
    "SerializationError",
    "UnknownInterfaceError",
    "add_prefixes",
    "copy_message",
    "definition_text",
    "deserialize",
    "forget",
    "get_action",
    "get_interface",
    "get_message",
    "get_service",
    "interface_names",
    "packages",
    "serialize",
    "type_hash",
    "type_name",
]

# A talker that never meets another process needs none of these.
_LAZY = {
    "DeserializationError": "cdr",
    "SerializationError": "cdr",
    "copy_message": "copying",
    "deserialize": "cdr",
    "serialize": "cdr",
    "type_hash": "hashing",
}


def __getattr__(name: str) -> Any:
    if name not in _LAZY:
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    from importlib import import_module

    value = getattr(import_module(f"{__name__}.{_LAZY[name]}"), name)
    globals()[name] = value
    return value
