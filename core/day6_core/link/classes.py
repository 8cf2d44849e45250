"""Maps a type name, from a token or an endpoint, to its message or service class, including the parts of actions."""

from __future__ import annotations

from typing import Any

from day6_core.interfaces import get_action, get_message, get_service

_ACTION_SERVICES = {"_SendGoal": "SendGoalService", "_GetResult": "GetResultService"}
_SERVICE_PARTS = ("_Request", "_Response", "_Event")


def message_class(type_name: str) -> Any:
    """Return the class of a topic's type: a message, an action's feedback message or a service's event.

    Raises:
        LookupError, ValueError: as `get_message` does for an unknown name.
    """
    base, separator, part = type_name.rpartition("_")
    if "/action/" in type_name and part == "FeedbackMessage":
        return get_action(base).Impl.FeedbackMessage
    if "/srv/" in type_name and separator + part in _SERVICE_PARTS:
        return getattr(get_service(base), part)
    return get_message(type_name)


def service_class(type_name: str) -> Any:
    """Return the class of a service's type, including an action's two services; raises the errors of `get_service`."""
    base, separator, part = type_name.rpartition("_")
    if "/action/" in type_name and separator + part in _ACTION_SERVICES:
        return getattr(get_action(base).Impl, _ACTION_SERVICES[separator + part])
    return get_service(type_name)
