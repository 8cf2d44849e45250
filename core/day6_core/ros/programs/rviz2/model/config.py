"""The .rviz file: YAML as yaml-cpp writes it for RViz, read without trusting it."""

from __future__ import annotations

import re
from typing import Any

MOST_BYTES = 4_000_000
DEEPEST = 60
"""Levels of nesting; RViz's own files have about eight."""


class ConfigError(ValueError):
    """The file isn't an RViz configuration; `str()` says why."""


def read_config(text: str) -> dict[str, Any]:
    """The map that a .rviz file holds. Raises ConfigError."""
    import yaml

    if len(text) > MOST_BYTES:
        raise ConfigError(f"more than {MOST_BYTES // 1_000_000} MB")

    class Loader(yaml.SafeLoader):
        """Without aliases: RViz writes none, and a short file can stand for terabytes with them."""

        def compose_node(self, parent: Any, index: Any) -> Any:
            if self.check_event(yaml.events.AliasEvent):
                raise ConfigError("aliases are not allowed")
            return super().compose_node(parent, index)

    try:
        loader = Loader(text)
        try:
            loaded = loader.get_single_data()
        finally:
            loader.dispose()
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f"line {mark.line + 1}, column {mark.column + 1}: " if mark is not None else ""
        raise ConfigError(f"{where}{getattr(error, 'problem', None) or 'this is not YAML'}") from None
    except (RecursionError, ValueError) as error:
        if isinstance(error, ConfigError):
            raise
        raise ConfigError(str(error) or "nested too deeply") from None
    if not isinstance(loaded, dict):
        raise ConfigError("this is not an RViz configuration")
    if _depth(loaded) > DEEPEST:
        raise ConfigError("nested too deeply")
    return loaded


def _depth(value: Any) -> int:
    deepest, waiting = 0, [(value, 1)]
    while waiting and deepest <= DEEPEST:
        each, depth = waiting.pop()
        deepest = max(deepest, depth)
        if isinstance(each, dict):
            waiting += [(child, depth + 1) for child in each.values()]
        elif isinstance(each, list):
            waiting += [(child, depth + 1) for child in each]
    return deepest


def write_config(config: dict[str, Any]) -> str:
    """The text of a .rviz file: keys sorted, lists indented, empty maps as `{}` on a line of their own."""
    return "\n".join(_map_lines(config, "")) + "\n"


def _map_lines(mapping: dict[str, Any], indent: str) -> list[str]:
    lines = []
    for key in sorted(mapping, key=str):
        value, name = mapping[key], indent + _scalar(str(key)) + ":"
        if isinstance(value, dict) and value:
            lines += [name, *_map_lines(value, indent + "  ")]
        elif isinstance(value, dict):
            lines += [name, indent + "  {}"]
        elif isinstance(value, list) and value:
            lines += [name, *_list_lines(value, indent + "  ")]
        elif isinstance(value, list):
            lines += [name, indent + "  []"]
        else:
            lines.append(f"{name} {_scalar(value)}")
    return lines


def _list_lines(items: list[Any], indent: str) -> list[str]:
    lines = []
    for item in items:
        if isinstance(item, dict) and item:
            first, *rest = _map_lines(item, indent + "  ")
            lines += [f"{indent}- {first.lstrip()}", *rest]
        elif isinstance(item, list) and item:
            first, *rest = _list_lines(item, indent + "  ")
            lines += [f"{indent}- {first.lstrip()}", *rest]
        else:
            empty = "{}" if isinstance(item, dict) else "[]" if isinstance(item, list) else _scalar(item)
            lines.append(f"{indent}- {empty}")
    return lines


_PLAIN = re.compile(r"[^\s\-?:,\[\]{}#&*!|>'\"%@`][^\n\t]*\Z")


def _scalar(value: Any) -> str:
    if value is None:
        return "~"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    text = str(value)
    if (text.startswith("<") or _PLAIN.match(text)) and _is_plain(text):
        return text
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t")
    return f'"{escaped}"'


def _is_plain(text: str) -> bool:
    """Whether YAML reads the text, written without quotes, as the text it is."""
    if ": " in text or " #" in text or text.endswith(":") or text != text.strip():
        return False
    import yaml

    if not text.isprintable():
        return False
    loader: Any = yaml.SafeLoader("")
    return bool(loader.resolve(yaml.ScalarNode, text, (True, False)) == "tag:yaml.org,2002:str")
