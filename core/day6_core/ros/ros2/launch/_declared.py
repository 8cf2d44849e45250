"""The arguments that a launch file declares, read from its text: Tab must not run a user's program.

Only `ros2 launch --show-args` sees names and values that a Python file computes, and those of included files.
"""

from __future__ import annotations

import ast
import os
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

_TRUTH = ("true", "false")
_MOST = 1_000_000
"""The largest file that is read, in bytes; launch files are never that long."""


class Declared(NamedTuple):
    """An argument: its name, and the values worth offering (the choices, or the default and its opposite)."""

    name: str
    values: tuple[str, ...]


def declared_arguments(file: Path) -> list[Declared]:
    """Return the arguments that a launch file declares, in its order; empty for a file that cannot be read."""
    try:
        text = file.read_text(encoding="utf-8") if file.stat().st_size <= _MOST else ""
        if file.name.endswith(".py"):
            return list(_python(text))
        return list(_yaml(text) if file.name.endswith((".yaml", ".yml")) else _xml(text))
    except (OSError, ValueError, SyntaxError):
        return []


def _declared(name: object, default: object, choices: Iterable[object] = ()) -> Declared | None:
    if not isinstance(name, str):
        return None
    offered = [str(choice) for choice in choices] or [default if isinstance(default, str) else ""]
    if offered[0].lower() in _TRUTH and len(offered) == 1:
        offered += [word for word in _TRUTH if word != offered[0].lower()]
    # A substitution such as `$(find-pkg-share …)` isn't worth completing.
    return Declared(name, tuple(value for value in offered if value and "$(" not in value))


def _python(text: str) -> Iterable[Declared]:
    # ast.walk goes level by level; we want the order of the lines.
    calls = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Call)]
    for call in sorted(calls, key=lambda node: (node.lineno, node.col_offset)):
        function = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
        if function != "DeclareLaunchArgument":
            continue
        given = {keyword.arg: keyword.value for keyword in call.keywords}
        choices = given.get("choices")
        found = _declared(
            _constant(call.args[0] if call.args else given.get("name")),
            _constant(given.get("default_value")),
            [_constant(choice) for choice in choices.elts] if isinstance(choices, (ast.List, ast.Tuple)) else (),
        )
        if found is not None:
            yield found


def _constant(node: ast.expr | None) -> object:
    return node.value if isinstance(node, ast.Constant) else None


def _xml(text: str) -> Iterable[Declared]:
    from day6_core.plain_xml import plain_xml

    try:
        root = plain_xml(text)
    except ValueError:
        return
    for element in root.iter("arg"):
        choices = [choice.get("value") for choice in element.iter("choice")]
        # Inside <include> an <arg> sets an argument of the other file; only such ones have a value.
        found = None if element.get("value") else _declared(element.get("name"), element.get("default"), choices)
        if found is not None:
            yield found


def _yaml(text: str) -> Iterable[Declared]:
    import yaml

    try:
        document = yaml.safe_load(text)
    except yaml.YAMLError:
        return
    entities = document.get("launch") if isinstance(document, dict) else None
    for entity in entities if isinstance(entities, list) else []:
        argument = entity.get("arg") if isinstance(entity, dict) else None
        if isinstance(argument, dict):
            default = argument.get("default")
            text_of = str(default).lower() if isinstance(default, bool) else default
            found = _declared(argument.get("name"), text_of if text_of is None else str(text_of))
            if found is not None:
                yield found


def offered(file: Path, prefix: str, given: Iterable[str]) -> list[str]:
    """Return completions of `prefix`: `name:=` of arguments that aren't in `given`, or `name:=value`."""
    arguments = declared_arguments(file)
    name, separator, _ = prefix.partition(":=")
    if separator:
        return [f"{name}:={value}" for argument in arguments if argument.name == name for value in argument.values]
    taken = {word.partition(":=")[0] for word in given}
    return [f"{argument.name}:=" for argument in arguments if argument.name not in taken]


def find_file(folder: str, name: str) -> Path | None:
    """Return the first file called `name` below a package's share folder."""
    return next((Path(parent, name) for parent, _, files in os.walk(folder) if name in files), None)
