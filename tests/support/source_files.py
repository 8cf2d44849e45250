"""The project's sources for tests that read them all: parsed one at a time, where a word stands that the test is about."""

from __future__ import annotations

import ast
import shutil
import unicodedata
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = {"day6_core": ROOT / "core", "day6_tui": ROOT / "tui", "day6_urdf": ROOT / "urdf"}
"""What is installed, and the folder of each."""

ON_THE_PATH = PACKAGES["day6_core"] / "day6_core" / "ros" / "python"
OF_DISTRIBUTIONS = ON_THE_PATH.with_name("python_of")
SHARE = ON_THE_PATH.with_name("share")
"""Data of the package: programs find the first two on sys.path, launch files and configurations in the third."""


def copy_of_checkout(place: Path) -> Path:
    """Copy the repository without what tools have left in it; returns the place."""
    left = ("__pycache__", ".*_cache", ".git", ".hypothesis", ".venv*", "build", "dist")
    return Path(shutil.copytree(ROOT, place, ignore=shutil.ignore_patterns(*left)))


def place(name: str) -> Path:
    """Return where something is that is named as from its package on (`day6_core/shell`), or from the repository (`tests`)."""
    return PACKAGES.get(name.partition("/")[0], ROOT) / name


def sources(*names: str) -> Iterator[tuple[Path, str]]:
    """Yield name, as for `place`, and text of every module in these folders (of what is installed, if none)."""
    for name in names or PACKAGES:
        folder = place(name)
        for path in sorted(folder.rglob("*.py")):
            yield Path(name, path.relative_to(folder)), path.read_text(encoding="utf-8")


def trees(*names: str, words: tuple[str, ...] = ("",)) -> Iterator[tuple[Path, ast.Module]]:
    """Yield name and tree of the modules that have one of the words in their text, in any place.

    Whoever keeps no tree needs the memory of one: all together are some hundred megabytes.
    """
    for path, text in sources(*names):
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
