"""Writes plain values as YAML the way ROS tools print messages: Unicode unescaped, no line folded, order kept.

The output is PyYAML's, but twenty times as fast: a long array must not block all other programs. PyYAML itself writes the
rare cases: strings that need quotes, and whole values that contain strings of several lines.
"""

from __future__ import annotations

import re
import sys
from collections import OrderedDict
from collections.abc import Iterator
from functools import cache, lru_cache
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import yaml

_PLAIN = re.compile(r"[A-Za-z_/][A-Za-z0-9_/.-]*")
_WORDS_OF_YAML = frozenset({"yes", "no", "true", "false", "on", "off", "null"})
_LINE_BREAKS = re.compile("[\n\r\x85\u2028\u2029]")


class _NeedsPyYAML(Exception):
    """Raised for rare and intricate values, such as strings of several lines, which are indented by their depth."""


def dump(value: Any, *, flow_style: bool = False) -> str:
    """Return the YAML text of dicts, lists and scalars, with a newline at its end.

    With `flow_style` sequences are on one line; mappings outside of sequences stay in block style, as in the real tools.
    """
    try:
        if isinstance(value, dict) and value:
            return "".join(f"{line}\n" for line in _block_mapping(value, "", flow_style))
    except _NeedsPyYAML:
        # Found only while writing, because it is so rare.
        return dump_with_pyyaml(value, flow_style=flow_style)
    return dump_with_pyyaml(value, flow_style=flow_style)


def one_line(value: Any) -> str:
    """Return a value as YAML on one line, as typed on a command line: `{linear: {x: 0.0}}`."""
    try:
        return _flow(value)
    except _NeedsPyYAML:
        return dump_with_pyyaml([value], flow_style=True)[1:-2]


def _block_mapping(mapping: dict[str, Any], indent: str, flow_style: bool) -> Iterator[str]:
    for name, value in mapping.items():
        key = _scalar(name, False)
        if isinstance(value, dict) and value:
            yield f"{indent}{key}:"
            yield from _block_mapping(value, f"{indent}  ", flow_style)
        elif isinstance(value, (list, tuple)) and value and not flow_style:
            yield f"{indent}{key}:"
            yield from _block_sequence(value, indent)
        else:
            yield f"{indent}{key}: {_flow(value) if isinstance(value, (dict, list, tuple)) else _scalar(value, False)}"


def _block_sequence(items: Any, indent: str) -> Iterator[str]:
    for item in items:
        if isinstance(item, dict) and item:
            lines = _block_mapping(item, f"{indent}  ", False)
            yield f"{indent}- {next(lines).lstrip(' ')}"
            yield from lines
        elif isinstance(item, (list, tuple)):
            raise _NeedsPyYAML
        else:
            yield f"{indent}- {'{}' if item == {} else _scalar(item, False)}"


def _flow(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_scalar(name, True)}: {_flow(item)}" for name, item in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_flow, value)) + "]"
    return _scalar(value, True)


def _scalar(value: Any, flow: bool) -> str:
    kind = value.__class__
    if kind is int:
        return str(value)
    if kind is float:
        return _float(value)
    if kind is bool:
        return "true" if value else "false"
    if kind is str:
        return value if _PLAIN.fullmatch(value) and value.lower() not in _WORDS_OF_YAML else _string(value, flow)
    if value is None:
        return "null"
    raise _NeedsPyYAML


def _float(value: float) -> str:
    if value != value:
        return ".nan"
    if value in (float("inf"), float("-inf")):
        return ".inf" if value > 0 else "-.inf"
    text = repr(value)
    # YAML 1.1 reads 1e-07 as a string: a float needs a dot.
    return text.replace("e", ".0e", 1) if "." not in text and "e" in text else text


@lru_cache(maxsize=1024)
def _string(text: str, flow: bool) -> str:
    if _LINE_BREAKS.search(text):
        raise _NeedsPyYAML
    written = dump_with_pyyaml([text], flow_style=flow)
    return written[1:-2] if flow else written[2:-1]


def dump_with_pyyaml(value: Any, *, flow_style: bool) -> str:
    """Return PyYAML's text of a value."""
    import yaml

    return str(yaml.dump(value, Dumper=_dumper(), allow_unicode=True, width=sys.maxsize, default_flow_style=flow_style))


@cache
def _dumper() -> type[yaml.SafeDumper]:
    """Return a dumper of our own: registering OrderedDict with PyYAML's would change it for the whole process."""
    import yaml

    class MessageDumper(yaml.SafeDumper):
        pass

    def represent_ordered(dumper: yaml.SafeDumper, data: OrderedDict[str, Any]) -> yaml.MappingNode:
        pairs = [(dumper.represent_data(key), dumper.represent_data(item)) for key, item in data.items()]
        return yaml.MappingNode("tag:yaml.org,2002:map", pairs)

    MessageDumper.add_representer(OrderedDict, represent_ordered)
    return MessageDumper
