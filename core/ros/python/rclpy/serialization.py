"""Messages to bytes (CDR) and back."""

from __future__ import annotations

from typing import Any

from day6_tui.core.interfaces import deserialize, serialize
from rclpy.type_support import check_for_type_support


def serialize_message(message: Any) -> bytes:
    """Return a message as CDR bytes with the 4-byte header."""
    check_for_type_support(type(message))
    return serialize(message)


def deserialize_message(serialized_message: bytes, message_type: Any) -> Any:
    """Return the message of class `message_type` that CDR bytes hold."""
    check_for_type_support(message_type)
    return deserialize(serialized_message, message_type)
