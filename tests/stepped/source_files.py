"""The project's sources for tests that read them all: parsed one at a time, where a word stands that the test is about."""

from __future__ import annotations

import ast
import unicodedata
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOPS = ("core", "tui", "urdf")


def sources(*tops: str) -> Iterator[tuple[Path, str]]:
    """Yield path, within the repository, and text of every module below these folders (those that are installed, if none)."""
    for top in tops or TOPS:
        for path in sorted((ROOT / top).rglob("*.py")):
            yield path.relative_to(ROOT), path.read_text(encoding="utf-8")


def trees(*tops: str, words: tuple[str, ...] = ("",)) -> Iterator[tuple[Path, ast.Module]]:
    """Yield path and tree of the modules that have one of the words in their text, in any place.

    Whoever keeps no tree needs the memory of one: all together are some hundred megabytes.
    """
    for path, text in sources(*tops):
        read = text if text.isascii() else unicodedata.normalize("NFKC", text)  # as Python reads names
        if any(word in read for word in words):
            yield path, ast.parse(text)


def nodes(*trees: ast.AST) -> Iterator[ast.AST]:
    """Yield every node of the trees that has a part, in no order; `ast.walk` needs twice the time."""
    todo = list(trees)
    while todo:
        node = todo.pop()
        yield node
        for name in node._fields:
            value = getattr(node, name, None)
            for each in value if isinstance(value, list) else (value,):
                if isinstance(each, ast.AST) and each._fields:
                    todo.append(each)


def statements(tree: ast.Module) -> Iterator[ast.AST]:
    """Yield the module and every statement in it, however deep, without their expressions."""
    todo: list[ast.AST] = [tree]
    while todo:
        node = todo.pop()
        yield node
        for name in ("body", "orelse", "finalbody", "handlers", "cases"):
            todo += getattr(node, name, ())
