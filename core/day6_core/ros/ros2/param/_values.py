"""Parameter values: read from the text of a command line, converted to Python, and the names of their types."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros import differences

if TYPE_CHECKING:
    from rcl_interfaces.msg import ParameterValue

_KINDS = {
    # ParameterType: (field of ParameterValue, name of the type, label of `param get`)
    1: ("bool_value", "boolean", "Boolean value is:"),
    2: ("integer_value", "integer", "Integer value is:"),
    3: ("double_value", "double", "Double value is:"),
    4: ("string_value", "string", "String value is:"),
    5: ("byte_array_value", "byte array", "Byte values are:"),
    6: ("bool_array_value", "boolean array", "Boolean values are:"),
    7: ("integer_array_value", "integer array", "Integer values are:"),
    8: ("double_array_value", "double array", "Double values are:"),
    9: ("string_array_value", "string array", "String values are:"),
}
NOT_SET = 0
_SCALARS: tuple[tuple[type, int], ...] = ((bool, 1), (int, 2), (float, 3))
_ARRAYS: tuple[tuple[type, int], ...] = ((bool, 6), (int, 7), (float, 8), (str, 9))
_STRING = 4


def type_name(kind: int) -> str:
    """Return the name of a parameter type as `param describe` prints it."""
    return "not set" if kind == NOT_SET else _KINDS[kind][1]


def label(kind: int) -> str:
    """Return the label that `param get` prints before a value."""
    return _KINDS[kind][2]


def is_known(kind: int) -> bool:
    """Return whether a type number is one of those that have a value."""
    return kind in _KINDS


def python_value(value: ParameterValue) -> Any:
    """Return the value as a Python type, arrays as lists; None if it is not set."""
    if value.type == NOT_SET:
        return None
    found = getattr(value, _KINDS[value.type][0])
    return list(found) if type_name(value.type).endswith("array") else found


def shown_value(value: ParameterValue) -> Any:
    """Return what `param get` prints of a value."""
    plain = python_value(value)
    numbers = type_name(value.type) in ("integer array", "double array")
    if numbers and differences.value("param.get_arrays") == "array":
        return getattr(value, _KINDS[value.type][0])
    return plain


def value_from_text(text: str) -> ParameterValue:
    """Guess the type of a value from its text, by the rules of YAML 1.1 (`no` is false, `[1, 2]` an integer array)."""
    import yaml
    from rcl_interfaces.msg import ParameterValue

    try:
        found = yaml.safe_load(text)
    except yaml.parser.ParserError:
        found = text
    kind = _kind_of(found)
    if kind == _STRING and (found is None or isinstance(found, list)):
        found = text
    value = ParameterValue(type=kind)
    setattr(value, _KINDS[kind][0], found)
    return value


def value_of(found: Any) -> ParameterValue:
    """Return the ParameterValue of a value that YAML has already parsed (from a parameter file)."""
    from rcl_interfaces.msg import ParameterValue

    kind = _kind_of(found)
    value = ParameterValue(type=kind)
    setattr(value, _KINDS[kind][0], found if kind != _STRING or isinstance(found, str) else str(found))
    return value


def _kind_of(found: Any) -> int:
    for python_type, kind in _SCALARS:
        if isinstance(found, python_type):
            return kind
    if isinstance(found, list):
        for python_type, kind in _ARRAYS:
            if all(isinstance(item, python_type) for item in found):
                return kind
    return _STRING
