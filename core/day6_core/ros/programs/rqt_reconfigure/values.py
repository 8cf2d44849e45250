"""Values of parameters as text: what a field shows, and what is typed into it."""

from __future__ import annotations

from typing import Any

from rclpy.parameter import Parameter

Type = Parameter.Type

LONGEST = 1_000
"""Characters of a value that are made into text; more are told by their number."""


class Unfitting(ValueError):
    """What was typed is no value of the parameter's type."""


def name_of(kind: int) -> str:
    """The name of a type, as it is known from `ros2 param describe`."""
    name = Type(kind).name.lower().replace("_", " ")
    return name.replace("bool", "boolean")


def text_of(value: Any) -> str:
    """A value as it is shown and typed: a string as it is, an array in YAML's flow style."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(_element(each) for each in value)}]"
    return str(value)


def shown(value: Any) -> str:
    """The beginning of a value's text, as much as a line can have."""
    if isinstance(value, (str, list)) and len(value) > LONGEST:
        return f"{text_of(value[:LONGEST])} ({len(value)})"
    return text_of(value)


def _element(value: Any) -> str:
    if isinstance(value, bytes):
        return str(value[0]) if value else "0"
    if isinstance(value, str):
        import json

        return json.dumps(value, ensure_ascii=False)  # which is YAML too
    return text_of(value)


def value_from(text: str, kind: int) -> Any:
    """The value of a type that a text says. Raises Unfitting."""
    kind = Type(kind)
    if kind == Type.STRING:
        return text
    try:
        if kind == Type.INTEGER:
            return _in_64_bits(int(text.strip(), 0))
        if kind == Type.DOUBLE:
            return float(text)
        if kind == Type.BOOL:
            return {"true": True, "false": False}[text.strip().lower()]
        return [_from_yaml(each, kind) for each in _list(text)]
    except (ValueError, KeyError) as error:
        raise Unfitting(text) from error


def _list(text: str) -> list[Any]:
    import yaml

    try:
        found = yaml.safe_load(text)
    except (yaml.YAMLError, RecursionError) as error:
        raise ValueError(str(error)) from error
    if not isinstance(found, list):
        raise ValueError("not a list")
    return found


def _from_yaml(value: Any, kind: Type) -> Any:
    """An element of an array. Raises ValueError."""
    if kind == Type.STRING_ARRAY and not isinstance(value, (list, dict)):
        return value if isinstance(value, str) else text_of(value)
    if kind == Type.BOOL_ARRAY and isinstance(value, bool):
        return value
    if isinstance(value, int) and not isinstance(value, bool):
        if kind == Type.INTEGER_ARRAY:
            return _in_64_bits(value)
        if kind == Type.BYTE_ARRAY:
            return bytes([value])
    if kind == Type.DOUBLE_ARRAY and isinstance(value, (int, float, str)) and not isinstance(value, bool):
        return float(value)  # YAML 1.1 reads 1e+300 and nan as strings
    raise ValueError(str(value))


def _in_64_bits(value: int) -> int:
    if not -(2**63) <= value < 2**63:
        raise ValueError(f"{value} has more than 64 bits")
    return value
