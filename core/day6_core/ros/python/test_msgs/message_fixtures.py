"""Messages of test_msgs with values at the limits of their types, for tests of message transport."""

from __future__ import annotations

import re
from typing import Any

_INTEGER = re.compile(r"(u?)int(\d+)")
_TEXT = re.compile(r"w?string(?:<(\d+)>)?")
_COLLECTION = re.compile(r"(?:sequence<(?P<item>.+?)(?:, (?P<limit>\d+))?>|(?P<element>.+)\[(?P<size>\d+)\])")


def get_test_msg(message_name: str) -> list[Any]:
    """Return messages of `test_msgs/msg/<message_name>`: default ones, and with low, high and ordinary values.

    Raises NotImplementedError for a name that isn't in test_msgs.
    """
    from test_msgs import msg

    message_type = getattr(msg, message_name, None)
    if message_type is None:
        raise NotImplementedError
    if not message_type.get_fields_and_field_types() or message_name == "Constants":
        return [message_type()]
    return [message_type(), *(_filled(message_type(), step) for step in range(3))]


def _filled(message: Any, step: int) -> Any:
    for name, type_text in message.get_fields_and_field_types().items():
        setattr(message, name, _value(type_text, step, getattr(message, name)))
    return message


def _value(type_text: str, step: int, default: Any) -> Any:
    collection = _COLLECTION.fullmatch(type_text)
    if collection:
        item = collection["item"] or collection["element"]
        length = int(collection["size"]) if collection["size"] else min(int(collection["limit"] or 3), 3)
        return [_value(item, (step + index) % 3, None) for index in range(length)]
    integer = _INTEGER.fullmatch(type_text)
    if integer:
        unsigned, bits = bool(integer[1]), int(integer[2])
        low, high = (0, 2**bits - 1) if unsigned else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)
        return (low, high, 7)[step]
    if type_text in ("float", "double"):
        return (-1.125, 3.5, 0.0)[step]
    if type_text in ("octet", "byte"):
        return (b"\x00", b"\xff", b"\x01")[step]
    if type_text in ("boolean", "bool"):
        return step == 1
    text = _TEXT.fullmatch(type_text)
    if text:
        value = ("", "a text", "Größe ½" if type_text.startswith("w") else "with 'quotes'")[step]
        return value[: int(text[1])] if text[1] else value
    return _nested(type_text, step, default)


def _nested(type_text: str, step: int, default: Any) -> Any:
    if default is None:
        from rosidl_runtime_py.utilities import get_message

        package, name = type_text.split("/")
        default = get_message(f"{package}/msg/{name}")()
    return _filled(default, step)
