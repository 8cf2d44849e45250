"""Imports the class of a type description."""

from __future__ import annotations

from importlib import import_module
from typing import Any


def import_message_from_namespaced_type(message_type: Any) -> Any:
    """Return the class of a `rosidl_parser.definition.NamespacedType`.

    Raises ModuleNotFoundError for an unknown package, AttributeError for an unknown name.
    """
    module = import_module(".".join(message_type.namespaces))
    name = message_type.name
    if name.endswith("_FeedbackMessage"):
        # It isn't a name of the module: it is inside the action class.
        action, _, part = name.rpartition("_")
        return getattr(getattr(module, action).Impl, part)
    return getattr(module, name)
