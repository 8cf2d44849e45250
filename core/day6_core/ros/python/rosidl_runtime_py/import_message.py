"""Imports the class of a type description."""

from __future__ import annotations

from importlib import import_module
from typing import Any


def import_message_from_namespaced_type(message_type: Any) -> Any:
    """Return the class of a `rosidl_parser.definition.NamespacedType`.

    An array of such a type is deprecated, as in real ROS. Raises ModuleNotFoundError for an unknown package, AttributeError for
    an unknown name.
    """
    if not hasattr(message_type, "namespaces") and hasattr(message_type, "value_type"):
        from warnings import warn

        message_type = message_type.value_type
        warn(
            "Passing objects containing a NamespacedType is deprecated, please pass a NamespacedType object directly",
            DeprecationWarning,
            stacklevel=1,
        )
    module = import_module(".".join(message_type.namespaces))
    name = message_type.name
    if name.endswith("_FeedbackMessage"):
        # It isn't a name of the module: it is inside the action class.
        action, _, part = name.rpartition("_")
        return getattr(getattr(module, action).Impl, part)
    return getattr(module, name)
