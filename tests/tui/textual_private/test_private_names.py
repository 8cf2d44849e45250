"""Textual's private names are used in one folder, and the installed Textual has all of them."""

from __future__ import annotations

import ast
import importlib
import inspect
import pkgutil
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import textual

import day6_tui
from day6_tui import main, textual_private
from tests.support.source_files import ROOT, trees

FOLDER = "day6_tui/textual_private/"


def is_private(name: str) -> bool:
    return name.startswith("_") and not name.startswith("__")


def names_made(tree: ast.AST) -> set[str]:
    """The private names that a module gives to functions, methods and attributes."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            found.add(node.name)
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            found.add(node.attr)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.add(node.id)
    return set(filter(is_private, found))


@cache
def of_textual() -> frozenset[str]:
    """The private names of the installed Textual, its modules included."""
    found: set[str] = set()
    for file in Path(textual.__file__).parent.rglob("*.py"):
        found |= names_made(ast.parse(file.read_text(encoding="utf-8"))) | {file.stem}
    return frozenset(filter(is_private, found))


@cache
def of_ours() -> tuple[dict[str, set[str]], dict[str, set[str]]]:
    """The private names that each module of the desktop makes, and those that it reads of others or imports from Textual."""
    made, read = {}, {}
    for path, tree in trees("day6_tui"):
        made[path.as_posix()] = names_made(tree)
        found = set()
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute):
                found.add(node.attr)
            elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "textual":
                found |= {*(node.module or "").split("."), *(each.name for each in node.names)}
        read[path.as_posix()] = set(filter(is_private, found))
    return made, read


def test_only_one_folder_reads_private_names_of_textual() -> None:
    made, read = of_ours()
    own = set().union(*(names for file, names in made.items() if not file.startswith(FOLDER)))
    elsewhere = {
        file: names & of_textual() - own - {"_exit"} for file, names in read.items() if not file.startswith(FOLDER)
    }
    assert {file: names for file, names in elsewhere.items() if names} == {}
    assert any("_exit" in names for file, names in read.items() if file.startswith(FOLDER))


def test_textual_still_has_every_private_name_that_is_read() -> None:
    """What fails here after an update of Textual is what the update has broken."""
    made, read = of_ours()
    missing = {file: names - of_textual() - made[file] for file, names in read.items() if file.startswith(FOLDER)}
    assert {file: names for file, names in missing.items() if names} == {}


def classes_of_ours() -> list[type[Any]]:
    found = []
    for module in pkgutil.walk_packages(day6_tui.__path__, "day6_tui."):
        if ".static" not in module.name and module.name not in ("day6_tui.web.jupyter",):
            loaded = importlib.import_module(module.name)
            found += [
                each for each in vars(loaded).values() if inspect.isclass(each) and each.__module__ == module.name
            ]
    return found


def test_no_class_elsewhere_overrides_a_private_name_of_textual_knowingly_or_by_chance() -> None:
    overridden = []
    for each in classes_of_ours():
        theirs = [base for base in each.__mro__ if base.__module__.startswith("textual.")]
        if each.__module__.startswith("day6_tui.textual_private"):
            continue
        for name, value in vars(each).items():
            written = inspect.isfunction(value) or isinstance(
                value, property
            )  # Textual itself sets others on every class
            if is_private(name) and written and any(name in vars(base) for base in theirs):
                overridden.append(f"{each.__module__}.{each.__name__}.{name}")
    assert overridden == []


def test_the_releases_that_were_tested_are_the_only_ones_that_are_installed() -> None:
    first, second = map(int, textual_private.TESTED.split("."))
    pinned = f'"textual>={first}.{second},<{first}.{second + 1}"'
    assert pinned in (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    assert textual_private.version().startswith(f"{textual_private.TESTED}.") and textual_private.supported()


@pytest.mark.parametrize(
    ("there", "supported"), [("8.2.1", True), ("8.3.0", False), ("9.0", False), ("8.20.1", False), ("", True)]
)
def test_the_desktop_does_not_start_with_another_release(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], there: str, supported: bool
) -> None:
    monkeypatch.setattr(textual_private, "version", lambda: there)
    assert textual_private.supported() is supported
    if supported:
        return
    for stream in (sys.stdin, sys.stderr):
        monkeypatch.setattr(stream, "isatty", lambda: True)
    assert main.main(["--lang", "en"]) == 2
    assert f"Textual {there} is installed; this day6-tui needs 8.2: pip install" in capsys.readouterr().err
