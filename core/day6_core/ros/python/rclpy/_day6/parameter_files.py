"""Parameter values and parameter files: YAML as rcl_yaml_param_parser reads it, with its error texts.

YAML itself is imported only for a value or file that needs it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from functools import cache
from typing import Any

_TRUE = frozenset(["y", "Y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"])
_FALSE = frozenset(["n", "N", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"])
_INTEGER = re.compile(r"[+-]?(0[xX][0-9a-fA-F]+|[0-9]+)\Z")
_HEXADECIMAL = re.compile(r"[+-]?0[xX][0-9a-fA-F.]+([pP][+-]?[0-9]+)?\Z")
_NEEDS_YAML = re.compile(r"""[\[\]{}"'#&*!|>%@`,]|: |:\Z|\A[-?]( |\Z)|\A---|\A\.\.\.|\A\s|\s\Z|[\t\n]""")
_MIXED_LINES = {"bool": 309, "integer": 350, "double": 391, "string": 435}
_RANKS = ("bool", "integer", "double", "string", "bool array", "integer array", "double array", "string array")
_SMALLEST = 2.2250738585072014e-308
PARAMETERS_KEY = "ros__parameters"

Overrides = dict[str, dict[str, Any]]
"""node pattern -> parameter name -> value, in the order of the files and arguments"""


class ParameterTextError(ValueError):
    """A text that the parser rejects; the message is the one that rcl prints after `Error: `."""

    def __init__(self, message: str, line: int) -> None:
        super().__init__(f"{message}, at /project/src/{'parser' if line == 271 else 'parse'}.c:{line}")


def add_override(parameters: dict[str, Any], name: str, value: Any) -> None:
    """Set the value of a parameter that may already have one.

    rcl keeps one value of every type and later takes the first that is set: a new value wins if its type is the same or comes
    earlier (rcl_yaml_param_parser, rcl_variant_t).
    """
    known = parameters.get(name)
    if known is None or _rank(value) <= _rank(known):
        parameters[name] = value


def _rank(value: Any) -> int:
    if value is None:
        return len(_RANKS)
    word = _type_word(value[0]) + " array" if isinstance(value, list) else _type_word(value)
    return _RANKS.index(word)


def plain_value(text: str) -> Any:
    """Return the value of an unquoted YAML scalar: a bool, an int (C notation), a float or the text itself."""
    if text in _TRUE:
        return True
    if text in _FALSE:
        return False
    if _INTEGER.match(text):
        sign, digits = (text[0], text[1:]) if text[0] in "+-" else ("", text)
        base = 16 if digits[:2] in ("0x", "0X") else 8 if digits[0] == "0" and len(digits) > 1 else 10
        try:
            number = int(sign + digits, base)
        except ValueError:
            number = 2**63
        if -(2**63) <= number < 2**63:
            return number
    floating = _floating_point(text)
    return text if floating is None else floating


def _floating_point(text: str) -> float | None:
    """Return the number that C's strtod reads from a whole text; None if there is none or a double cannot hold it."""
    lowered = text.lower()
    if lowered.lstrip("+-") in (".inf", ".nan"):
        return float(lowered.replace(".", ""))
    if "_" in text or text != text.strip():
        return None
    try:
        number = float.fromhex(text) if _HEXADECIMAL.match(text) else float(text)
    except (ValueError, OverflowError):
        return None
    too_large = math.isinf(number) and "inf" not in lowered
    too_small = abs(number) < _SMALLEST and any(digit in "123456789" for digit in lowered.partition("e")[0])
    return None if too_large or too_small else number


def assigned_value(text: str) -> Any:
    """Return the value of `-p name:=text`; None if YAML finds nothing in it. Raises ParameterTextError."""
    if not _NEEDS_YAML.search(text):
        return plain_value(text)
    import yaml

    values: list[Any] = []
    sequence = False
    try:
        for event in yaml.parse(text, Loader=yaml.SafeLoader):
            if isinstance(event, (yaml.MappingStartEvent, yaml.AliasEvent)):
                raise ParameterTextError("Unknown YAML event", 957)
            if isinstance(event, yaml.SequenceStartEvent):
                # A nested sequence or mapping: rcl forgets what it has read so far.
                sequence = True
                values = []
            elif isinstance(event, yaml.ScalarEvent):
                values.append(_scalar(event))
                if sequence:
                    _check_same_type(values, 1)
    except yaml.YAMLError:
        raise ParameterTextError("Error parsing an event", 927) from None
    if sequence:
        return values or None
    return values[0] if values else None


def _scalar(event: Any) -> Any:
    """Return a scalar's value; ParameterTextError if it has none."""
    if event.value == "" and event.style not in ("'", '"'):
        raise ParameterTextError(f"No value at line {event.start_mark.line + 1}", 258)
    if event.tag is not None:
        from day6_core.ros import differences

        kind = event.tag.removeprefix("tag:yaml.org,2002:")
        if kind in differences.value("parameters.yaml_tags"):
            return _tagged(event, kind)
    return event.value if event.style is not None else plain_value(event.value)


def _tagged(event: Any, kind: str) -> Any:
    """Return the value of a scalar whose tag says its type; ParameterTextError if it is of another one."""
    if kind == "str":
        return event.value
    value = plain_value(event.value)
    if kind == "float" and type(value) is int:
        value = float(value)
    if type(value).__name__ != kind:
        line = event.start_mark.line + 1
        raise ParameterTextError(
            f"Value '{event.value}' does not have the type of its tag '!!{kind}' at line {line}", 258
        )
    return value


def _type_word(value: Any) -> str:
    return {bool: "bool", int: "integer", float: "double"}.get(type(value), "string")


def _check_same_type(values: list[Any], line: int) -> None:
    for value in values[1:]:
        if type(value) is not type(values[0]):
            word = _type_word(value)
            message = f"Sequence should be of same type. Value type '{word}' do not belong at line_num {line}"
            raise ParameterTextError(message, _MIXED_LINES[word])


def read_parameter_file(path: str) -> Overrides:
    """Read a parameter file: node pattern -> parameter -> value. Raises ParameterTextError."""
    import yaml

    try:
        with open(path, "rb") as file:
            text = file.read().decode("utf-8", "replace")
    except IsADirectoryError:
        raise ParameterTextError("Error parsing a event near line 0", 776) from None
    except OSError:
        raise ParameterTextError("Error opening YAML file", 271) from None
    return _FileReader(_events(yaml, text)).read()


def _events(yaml: Any, text: str) -> Iterator[Any]:
    line = 0
    try:
        for event in yaml.parse(text, Loader=_loader()):
            line = event.start_mark.line + 1
            yield event
    except yaml.YAMLError:
        raise ParameterTextError(f"Error parsing a event near line {line}", 776) from None


@cache
def _loader() -> Any:
    """Return PyYAML's loader with libyaml's treatment of tabs: they separate tokens, except in a line's indentation."""
    import yaml

    class Loader(yaml.SafeLoader):
        def scan_to_next_token(self) -> None:
            super().scan_to_next_token()
            while self.peek() == "\t" and (self.flow_level or not self.allow_simple_key):
                self.forward()
                super().scan_to_next_token()

    return Loader


class _FileReader:
    """Reads the YAML events of a parameter file."""

    def __init__(self, events: Iterator[Any]) -> None:
        self._events = events
        self._found: Overrides = {}

    def _next(self) -> tuple[str, Any, int]:
        event = next(self._events)
        kind = type(event).__name__.removesuffix("Event")
        line = event.start_mark.line + 1
        if kind == "Alias":
            raise ParameterTextError(f"Will not support aliasing at line {line}\n", 885)
        return kind, event, line

    def read(self) -> Overrides:
        """Return everything found."""
        for event in self._events:
            kind = type(event).__name__
            if kind == "MappingStartEvent":
                self._nodes("")
            elif kind == "SequenceStartEvent":
                raise ParameterTextError(f"Sequences cannot be key at line {event.start_mark.line + 1}", 829)
        return self._found

    def _nodes(self, prefix: str) -> None:
        while True:
            kind, event, line = self._next()
            if kind == "MappingEnd":
                return
            if kind == "SequenceStart":
                raise ParameterTextError(f"Sequences cannot be key at line {line}", 829)
            if event.value == PARAMETERS_KEY:
                self._parameters_of(prefix, line)
                continue
            name = f"{prefix.rstrip('/')}/{event.value}" if prefix else event.value
            kind, event, line = self._next()
            if kind == "SequenceStart":
                message = f"Sequences can only be values and not keys in params. Error at line {line}\n"
                raise ParameterTextError(message, 835)
            if kind == "Scalar":
                raise ParameterTextError(f"Cannot have a value before ros__parameters at line {line}", 800)
            self._nodes(name)

    def _parameters_of(self, node: str, line: int) -> None:
        if not node:
            raise ParameterTextError(f"There are no node names before ros__parameters at line {line}", 642)
        _check_node_pattern(node)
        kind, _, line = self._next()
        if kind != "MappingStart":
            raise ParameterTextError(f"Cannot have a value before ros__parameters at line {line}", 812)
        self._parameters(self._found.setdefault(node, {}), "")

    def _parameters(self, found: dict[str, Any], prefix: str) -> bool:
        """Read the parameters of one mapping; return whether there were any."""
        any_found = False
        while True:
            kind, event, line = self._next()
            if kind == "MappingEnd":
                return any_found
            any_found = True
            if kind == "SequenceStart":
                raise ParameterTextError(f"Sequences cannot be key at line {line}", 829)
            if kind == "MappingStart":
                raise ParameterTextError(f"Internal error creating param namespace at line {line}", 681)
            if event.value == "":
                raise ParameterTextError(f"No key at line {line}", 619)
            name = prefix + event.value
            kind, event, line = self._next()
            if kind == "MappingStart":
                if not self._parameters(found, f"{name}."):
                    add_override(found, name, None)
            elif kind == "SequenceStart":
                add_override(found, name, self._sequence(line) or None)
            else:
                add_override(found, name, _scalar(event))

    def _sequence(self, line: int) -> list[Any]:
        values: list[Any] = []
        while True:
            kind, event, line = self._next()
            if kind == "SequenceEnd":
                return values
            if kind == "SequenceStart":
                values = self._sequence(line)
            elif kind == "Scalar":
                values.append(_scalar(event))
                _check_same_type(values, line)


def _check_node_pattern(name: str) -> None:
    from day6_core.graph import names

    before, slashes, _ = name.partition("//")
    if slashes:
        raise ParameterTextError(f"{before}// contains repeated forward slash", 557)
    for part in name.removeprefix("/").split("/"):
        flaw = None if part in ("*", "**") else names.flaw_of_node_name(part)
        if flaw is not None:
            raise ParameterTextError(flaw.message, 490)


def matches(pattern: str, full_name: str) -> bool:
    """Return whether a node pattern (`talker`, `/ns/talker`, `/*`, `/**/talker`) matches the node with that full name."""
    if not pattern.startswith("/"):
        pattern = f"/{pattern}"
    expression = "".join(
        {"/**": r"(/\w+)*", "/*": r"/\w+"}.get(part, re.escape(part)) for part in re.findall(r"/[^/]*", pattern)
    )
    return re.fullmatch(expression, full_name) is not None


def parameters_of_nodes(
    path: str, use_wildcard: bool, target_nodes: list[str] | None, namespace: str
) -> dict[str, Any]:
    """See `rclpy.parameter.parameter_dict_from_yaml_file`."""
    import yaml

    with open(path, encoding="utf-8") as file:
        content = yaml.safe_load(file)
    merged: dict[str, Any] = {}
    if use_wildcard and "/**" in _keys(content):
        merged.update(_checked(content["/**"], "wildcard(/**)"))
    for name in target_nodes or ():
        if not name:
            continue
        full = name if name.startswith("/") else f"/{name}"
        if full in _keys(content):
            merged.update(_checked(content[full], f"node {full}"))
        outer, base = full.rsplit("/", 1)
        if not outer and base in _keys(content):
            merged.update(_checked(content[base], f"node {base}"))
        elif outer in _keys(content) and base in _keys(content[outer]):
            merged.update(_checked(content[outer][base], f"namespace {outer} node {base}"))
    if not merged:
        raise RuntimeError("Param file does not contain any valid parameters")
    return _flatten(namespace, merged)


def _keys(mapping: Any) -> Any:
    """Return the keys; AttributeError for a file that isn't a mapping, as in real rclpy."""
    return mapping.keys()


def _checked(value: Any, subject: str) -> dict[str, Any]:
    if not isinstance(value, dict) and PARAMETERS_KEY not in value:
        raise RuntimeError(f"YAML file is not a valid ROS parameter file for {subject}")
    parameters: dict[str, Any] = value[PARAMETERS_KEY]
    return parameters


def _flatten(prefix: str, parameters: dict[str, Any]) -> dict[str, Any]:
    from rcl_interfaces.msg import Parameter as ParameterMsg

    from rclpy.parameter import PARAMETER_SEPARATOR_STRING, get_parameter_value

    flat: dict[str, Any] = {}
    for name, value in parameters.items():
        full = prefix + name
        if isinstance(value, dict):
            flat.update(_flatten(full + PARAMETER_SEPARATOR_STRING, value))
        else:
            flat[full] = ParameterMsg(name=full, value=get_parameter_value(str(value)))
    return flat
