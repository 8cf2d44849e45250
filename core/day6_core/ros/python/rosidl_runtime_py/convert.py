"""Converts messages to YAML, comma-separated values and ordered dictionaries (the output of `ros2 topic echo`)."""

from __future__ import annotations

import sys
from array import array
from collections import OrderedDict
from collections.abc import Iterator
from typing import Any, NamedTuple


class _Limits(NamedTuple):
    """Limits for long messages: `truncate_length` items or characters are kept (None: all)."""

    truncate_length: int | None
    no_arr: bool
    no_str: bool

    def cuts(self, value: Any) -> bool:
        return self.truncate_length is not None and len(value) > self.truncate_length


def message_to_yaml(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
    flow_style: bool = False,
) -> str:
    """Return the YAML text of a message, with a newline at its end.

    Arrays, bytes and strings longer than `truncate_length` are cut; `no_arr` and `no_str` replace them with a note of their
    type and length. `flow_style` writes sequences on one line.
    """
    from rosidl_runtime_py.yaml_text import dump

    plain = message_to_ordereddict(msg, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)
    return dump(plain, flow_style=flow_style)


def message_to_csv(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
) -> str:
    """Return all values of a message, nested ones included, separated by commas; options as for `message_to_yaml`."""
    return _csv_of_message(msg, _Limits(truncate_length, no_arr, no_str))


def message_to_ordereddict(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
) -> OrderedDict[str, Any]:
    """Return `{field: value}` in the order of the definition, nested messages likewise; options as for `message_to_yaml`."""
    return _ordered(msg, _Limits(truncate_length, no_arr, no_str))


def _convert_value(
    value: Any,
    *,
    field_type: Any = None,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
) -> Any:
    # Programs by others use it, though its name is private.
    return _plain(value, _Limits(truncate_length, no_arr, no_str), field_type)


def get_message_slot_types(msg: Any) -> OrderedDict[str, Any]:
    """Return `{field: type}` of a message, the types as `rosidl_parser.definition` describes them."""
    return OrderedDict(_fields(msg))


def _fields(msg: Any) -> Iterator[tuple[str, Any]]:
    return zip(msg.get_fields_and_field_types(), msg.SLOT_TYPES, strict=True)


def _ordered(msg: Any, limits: _Limits) -> OrderedDict[str, Any]:
    return OrderedDict((name, _plain(getattr(msg, name, None), limits, kind)) for name, kind in _fields(msg))


def _plain(value: Any, limits: _Limits, kind: Any = None) -> Any:
    """Return `value` as dicts, lists, strings, numbers and booleans only. `kind` is given for fields only."""
    if isinstance(value, (bool, int, float)) and type(value).__module__ != "numpy":
        return value
    if isinstance(value, str):
        if limits.no_str:
            return _string_note(value)
        return value[: limits.truncate_length] + "..." if limits.cuts(value) else value
    if isinstance(value, bytes):
        text = value.decode("latin-1")
        return text[: limits.truncate_length] + "..." if limits.cuts(text) else text
    if isinstance(value, (list, tuple, array)) or _is_ndarray(value):
        return _plain_sequence(value, limits, kind)
    if isinstance(value, dict):
        return {key: _plain(item, limits) for key, item in value.items()}
    if _is_numpy(value):
        return value.item()
    return _ordered(value, limits)


def _plain_sequence(value: Any, limits: _Limits, kind: Any) -> Any:
    if limits.no_arr and kind is not None:
        return _array_note(value, kind)
    kept = value[: limits.truncate_length] if limits.cuts(value) else value
    if isinstance(kept, array) or (_is_ndarray(kept) and kept.ndim == 1):
        items = kept.tolist()
    else:
        items = [_plain(item, limits) for item in kept]
    if limits.cuts(value):
        items.append("...")
    return tuple(items) if isinstance(value, tuple) else items


def _csv_of_message(msg: Any, limits: _Limits) -> str:
    line = ""
    for name, kind in _fields(msg):
        # A comma only follows text: after a first field that prints as nothing there is none.
        line += ("," if line else "") + _csv(getattr(msg, name), limits, kind)
    return line


def _csv(value: Any, limits: _Limits, kind: Any = None) -> str:
    if isinstance(value, (list, tuple, array)) or _is_ndarray(value):
        if limits.no_arr and kind is not None:
            return _array_note(value, kind)
        line = ""
        for number, item in enumerate(value):
            cut = limits.truncate_length is not None and number >= limits.truncate_length
            line += ("," if line else "") + ("..." if cut else _csv(item, limits))
            if cut:
                break
        return line
    if isinstance(value, str):
        if limits.no_str:
            return _string_note(value)
        return value[: limits.truncate_length] + "..." if limits.cuts(value) else value
    if isinstance(value, bytes):
        return str(value[: limits.truncate_length] + b"..." if limits.cuts(value) else value)
    if isinstance(value, (bool, int, float)) or _is_numpy(value):
        return str(value)
    return _csv_of_message(value, limits)


def _is_numpy(value: Any) -> bool:
    return type(value).__module__ == "numpy"


def _is_ndarray(value: Any) -> bool:
    # numpy is not imported for this: a value can only be an ndarray if something else has imported it, and to the end: another
    # thread may just be importing it.
    ndarray = getattr(sys.modules.get("numpy"), "ndarray", None)
    return ndarray is not None and isinstance(value, ndarray)


def _string_note(value: str) -> str:
    return f"<string length: <{len(value)}>>"


def _array_note(value: Any, kind: Any) -> str:
    item = _item_name(kind.value_type)
    shape = type(kind).__name__
    if shape == "Array":
        return f"<array type: {item}[{kind.size}]>"
    if shape == "BoundedSequence":
        return f"<sequence type: {item}[{kind.maximum_size}], length: {len(value)}>"
    return f"<sequence type: {item}, length: {len(value)}>"


def _item_name(kind: Any) -> str:
    """Return the type name of an array's items, by the names of rosidl's classes, whichever package provides them."""
    classes = [each.__name__ for each in type(kind).__mro__]
    if "BasicType" in classes:
        return str(kind.typename)
    if "AbstractString" in classes:
        return "string"
    if "AbstractWString" in classes:
        return "wstring"
    if "NamespacedType" in classes:
        return "/".join(kind.namespaced_name())
    return str(getattr(kind, "name", "unknown"))
