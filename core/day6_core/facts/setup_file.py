"""What a setup.py says, as far as it can be read without running it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from day6_core.facts.folders import text_of

_ENTRY = re.compile(r"\s*([\w.-]+)\s*=\s*([\w./-]+)\s*(?::\s*(\w+))?\s*(.*)")
_TWO_ENTRIES = re.compile(r"\s*[\w.-]+\s*=\s*[\w.]+:\w+?\s*[\w.-]+\s*=\s*[\w.]+:\w+\s*$")


class EntryPoint(NamedTuple):
    """One line of `console_scripts`: `name = module:function`, and what is wrong with it."""

    name: str
    module: str
    function: str
    flaw: str = ""
    """'' or 'py' (the module ends with .py), 'module' (there is no such file), 'function' (it is not in that file), 'form'."""


class Setup(NamedTuple):
    """A setup.py."""

    entry_points: tuple[EntryPoint, ...] = ()
    computed: tuple[str, ...] = ()
    """Names of entry points that stand elsewhere in a file whose `console_scripts` are computed."""
    comma: int = 0
    """The line that lacks the comma between two entry points, 0 if none does.

    Python joins two texts without a comma to one: 'a = p.a:main' 'b = p.b:main' is one entry, and no right one.
    """

    @property
    def programs(self) -> tuple[str, ...]:
        """The programs that it names."""
        return (*(entry.name for entry in self.entry_points if entry.flaw != "form"), *self.computed)


def read_setup(folder: Path) -> Setup:
    """Read the setup.py of a package's folder; one that is not there says nothing."""
    try:
        tree = ast.parse(text_of(folder / "setup.py"))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return Setup()
    nodes = list(ast.walk(tree))
    found: list[EntryPoint] = []
    is_computed = False
    for value in _console_scripts(nodes):
        try:
            found += [_entry_point(each, folder) for each in ast.literal_eval(value) if isinstance(each, str)]
        except (ValueError, TypeError):
            is_computed = True
    return Setup(tuple(found), tuple(_names_written(nodes)) if is_computed else (), _missing_comma(nodes))


def _console_scripts(nodes: list[ast.AST]) -> Iterator[ast.expr]:
    for node in nodes:
        if isinstance(node, ast.Dict):
            for key, value in zip(node.keys, node.values, strict=True):
                if isinstance(key, ast.Constant) and key.value == "console_scripts":
                    yield value


def _names_written(nodes: list[ast.AST]) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            found = _ENTRY.fullmatch(node.value)
            if found is not None and found[3] and not found[4]:
                yield found[1]


def _missing_comma(nodes: list[ast.AST]) -> int:
    for node in nodes:
        for text in node.elts if isinstance(node, ast.List) else ():
            joined = isinstance(text, ast.Constant) and isinstance(text.value, str) and _TWO_ENTRIES.match(text.value)
            if joined and text.end_lineno != text.lineno:
                return text.lineno
    return 0


def _entry_point(text: str, folder: Path) -> EntryPoint:
    found = _ENTRY.fullmatch(text)
    if found is None or not found[3] or found[4]:
        return EntryPoint(text.partition("=")[0].strip(), "", "", "form")
    name, module, function = found[1], found[2], found[3]
    if module.endswith(".py") or "/" in module:
        return EntryPoint(name, module, function, "py")
    path = folder.joinpath(*module.split("."))
    file = path.with_suffix(".py")
    if not file.is_file():
        flaw = "" if (path / "__init__.py").is_file() else "module"
        return EntryPoint(name, module, function, flaw)
    source = file.read_text(encoding="utf-8", errors="replace")
    there = re.search(rf"^\s*(?:async\s+)?def\s+{function}\b|\b{function}\s*=|import\b.*\b{function}\b", source, re.M)
    return EntryPoint(name, module, function, "" if there else "function")
