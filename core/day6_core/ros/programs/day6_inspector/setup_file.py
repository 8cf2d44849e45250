"""What a setup.py says, as far as it can be read without running it."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import NamedTuple

_ENTRY = re.compile(r"\s*([\w.-]+)\s*=\s*([\w./-]+)\s*(?::\s*(\w+))?\s*(.*)")


class EntryPoint(NamedTuple):
    """One line of `console_scripts`: `name = module:function`, and what is wrong with it."""

    name: str
    module: str
    function: str
    flaw: str = ""
    """'' or 'py' (the module ends with .py), 'module' (there is no such file), 'function' (it is not in that file), 'form'."""


class Setup(NamedTuple):
    """A setup.py."""

    entry_points: list[EntryPoint]
    unreadable: bool
    """Whether the entry points are computed, so that only running it would tell."""
    changed: float
    """When it was last written (seconds)."""

    def newer_than(self, installed: Path) -> bool:
        """Return whether it was changed after the build that wrote `installed`."""
        try:
            return self.changed > installed.stat().st_mtime and self.changed > installed.parent.stat().st_mtime
        except OSError:
            return False


def read_setup(text: str, folder: Path) -> Setup:
    """Read the text of `folder`/setup.py."""
    changed = (folder / "setup.py").stat().st_mtime
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return Setup([], True, changed)
    strings: list[str] = []
    unreadable = False
    for node in ast.walk(tree):
        if isinstance(node, ast.Dict):
            for key, value in zip(node.keys, node.values, strict=True):
                if isinstance(key, ast.Constant) and key.value == "console_scripts":
                    try:
                        strings += ast.literal_eval(value)
                    except (ValueError, TypeError):
                        unreadable = True
    return Setup([_entry_point(each, folder) for each in strings if isinstance(each, str)], unreadable, changed)


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
