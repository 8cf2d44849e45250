"""A message as a tree of fields: made only as deep, as long and as wide as it is looked at."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any, NamedTuple

from day6_core.interfaces import UnknownInterfaceError, get_interface

MOST_ELEMENTS = 100
"""Elements of an array that are told one by one; the last line then stands for the rest."""

MOST_READ = 1_000
"""Elements or characters of a value that is read as a text of its own."""


class Field(NamedTuple):
    """A field or element: its name, its type as rosidl's classes write it, its value (None without a message)."""

    name: str
    type: str
    value: Any


def fields(type_name: str, value: Any) -> list[Field]:
    """The fields of a message, with or without one, or the elements of an array; none of a plain value.

    Raises LookupError and ValueError for a type that is unknown here.
    """
    element = element_type(type_name)
    if element:
        values = () if value is None else value
        found = [Field(f"[{index}]", element, each) for index, each in enumerate(islice(values, MOST_ELEMENTS))]
        if len(values) > MOST_ELEMENTS:
            found.append(Field(f"[{MOST_ELEMENTS}] ... [{len(values) - 1}]", "", None))
        return found
    if "/" not in type_name:
        return []
    types: dict[str, str] = message_class(type_name).get_fields_and_field_types()
    return [Field(name, kind, None if value is None else getattr(value, name)) for name, kind in types.items()]


def has_fields(type_name: str, value: Any) -> bool:
    """Whether a branch can be opened: a message, or an array that is not empty."""
    if element_type(type_name):
        return value is not None and len(value) > 0
    return "/" in type_name


def summary(value: Any, room: int) -> str:
    """A value on one line, of about `room` characters: what is longer ends somewhere behind them."""
    text = ""
    for piece in _pieces(value, room):
        text += piece
        if len(text) > room:
            break
    return text[: room + 1]


def _pieces(value: Any, room: int) -> Iterator[str]:
    if value is None:
        return
    if isinstance(value, str):
        yield value[: room + 1]
    elif hasattr(value, "get_fields_and_field_types"):
        for index, name in enumerate(value.get_fields_and_field_types()):
            part = getattr(value, name)
            nested = hasattr(part, "get_fields_and_field_types")
            yield f"{', ' if index else ''}{name}: {'{' if nested else ''}"
            yield from _pieces(part, room)
            yield "}" if nested else ""
    elif hasattr(value, "__len__") and not isinstance(value, bytes):
        yield "["
        for index, element in enumerate(islice(value, room)):
            yield ", " if index else ""
            yield from _pieces(element, room)
        yield "]"
    else:
        yield str(value)


def element_type(type_name: str) -> str:
    """The type of an array's elements, '' if it is none: double[9], sequence<string, 3>."""
    if type_name.startswith("sequence<"):
        return type_name[len("sequence<") : -1].partition(",")[0]
    return type_name.rpartition("[")[0] if type_name.endswith("]") else ""


def message_class(type_name: str) -> Any:
    """The class of a type as topics (`a/msg/B`, `a/action/B_FeedbackMessage`) or fields (`a/B`, `a/B_Feedback`) name it.

    Raises LookupError and ValueError for a type that is unknown here, or no message.
    """
    package, _, name = type_name.rpartition("/")
    if "/" in package:
        found = get_interface(type_name)
    elif "_" not in name:
        found = get_interface(f"{package}/msg/{name}")
    else:  # a part of an action or service
        try:
            found = get_interface(f"{package}/action/{name}")
        except UnknownInterfaceError:
            found = get_interface(f"{package}/srv/{name}")
    if not hasattr(found, "get_fields_and_field_types"):
        raise ValueError(f"'{type_name}' is not a message")
    return found


def value_at(message: Any, names: Iterable[str]) -> Any:
    """The value of the field or element (`[7]`) of a message that these names lead to; None if there is none."""
    value = message
    for name in names:
        if name.startswith("[") and name.endswith("]"):
            index = name[1:-1]
            value = value[int(index)] if index.isdecimal() and int(index) < len(value) else None
        else:
            value = getattr(value, name, None)
    return value


def text_of(value: Any) -> str:
    """A value as a text of several lines, as `ros2 topic echo` prints it; very long ones are cut as there."""
    from rosidl_runtime_py.convert import message_to_yaml

    if hasattr(value, "get_fields_and_field_types"):
        return message_to_yaml(value, truncate_length=MOST_READ)
    if isinstance(value, (str, bytes)) or not hasattr(value, "__len__"):
        return str(value[:MOST_READ] if isinstance(value, (str, bytes)) else value)
    lines = []
    for each in islice(value, MOST_READ):
        lines.append("- " + text_of(each).rstrip("\n").replace("\n", "\n  "))
    return "\n".join([*lines, *["..."] * (len(value) > MOST_READ)])
