"""Fills a message from plain values, as leniently and as strictly as the real tools on the command line."""

from __future__ import annotations

from array import array
from collections.abc import Callable
from functools import partial
from typing import Any

from rosidl_runtime_py.convert import _is_ndarray, get_message_slot_types

StampSetter = Callable[[Any], None]


def set_message_fields(
    msg: Any, values: Any, expand_header_auto: bool = False, expand_time_now: bool = False
) -> list[StampSetter]:
    """Set the fields of `msg` from a dict and return functions that stamp it.

    A value of another type is converted by the field's own type (`str`, `float`, `int` …): `data: yes` makes a string
    'True'. The value 'auto' of a Header field (with `expand_header_auto`) and 'now' of a Time field (with
    `expand_time_now`) add a function to the returned list, which takes a Time.

    Raises AttributeError for an unknown field, TypeError where a dict is expected, ValueError for a value that can't be
    converted, AssertionError for one that the field checks refuse.
    """
    stamps: list[StampSetter] = []
    _fill(msg, values, stamps, auto=expand_header_auto, now=expand_time_now)
    return stamps


def _fill(msg: Any, values: Any, stamps: list[StampSetter], *, auto: bool, now: bool) -> None:
    if not hasattr(values, "items"):
        raise TypeError(f"Value '{values}' is expected to be a dictionary but is a {type(values).__name__}")
    slot_types: dict[str, Any] | None = None
    for name, given in values.items():
        if not isinstance(name, str):
            # An unquoted `off` or `1` as key; the text is Python 3.11's, later versions have another one.
            raise TypeError(f"attribute name must be string, not '{type(name).__name__}'")
        present = getattr(msg, name)
        kind = type(present)
        if _is(kind, "std_msgs.msg._header", "Header") and auto and given == "auto":
            stamps.append(partial(setattr, present, "stamp"))
            continue
        if _is(kind, "builtin_interfaces.msg._time", "Time") and now and given == "now":
            stamps.append(partial(setattr, msg, name))
            continue
        value = _converted(present, given, stamps, auto=auto, now=now)
        if slot_types is None:
            slot_types = get_message_slot_types(msg)
        item_class = _message_class_of_items(slot_types[name])
        if item_class is not None:
            for index, item in enumerate(value):
                message = item_class()
                _fill(message, item, stamps, auto=auto, now=now)
                value[index] = message
        setattr(msg, name, value)


def _converted(present: Any, given: Any, stamps: list[StampSetter], *, auto: bool, now: bool) -> Any:
    kind = type(present)
    if isinstance(present, array):
        return array(present.typecode, given)
    if _is_ndarray(present):
        import numpy

        return numpy.array(given, dtype=present.dtype)
    if type(given) is kind:
        return given
    try:
        return kind(given)
    except TypeError:
        nested = kind()
        _fill(nested, given, stamps, auto=auto, now=now)
        return nested


def _is(kind: type, module: str, name: str) -> bool:
    # By name, so that a tool for all interfaces does not load these two.
    return kind.__name__ == name and kind.__module__ == module


def _message_class_of_items(slot_type: Any) -> Any:
    """Return the message class of an array's items, None for other fields."""
    item_type = getattr(slot_type, "value_type", None)
    if item_type is None or not hasattr(item_type, "namespaces"):
        return None
    from rosidl_runtime_py.import_message import import_message_from_namespaced_type

    return import_message_from_namespaced_type(item_type)
