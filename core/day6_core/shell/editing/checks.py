"""Checks a text while it is typed: Python by its compiler, XML and YAML by their parsers, URDF as check_urdf does."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

XML_SUFFIXES = (".xml", ".launch", ".xacro", ".sdf", ".world")
YAML_SUFFIXES = (".yaml", ".yml", ".rviz")


class Problem(NamedTuple):
    """The first thing that is wrong: line and column count from 1; the message is the tool's own."""

    line: int
    column: int
    message: str


def language_of(path: Path) -> str:
    """Return 'python', 'xml', 'yaml', 'bash', 'markdown' or '' for a file by its name."""
    suffix = path.suffix.lower()
    if suffix in (".py", ".pyi"):
        return "python"
    if suffix in (*XML_SUFFIXES, ".urdf"):
        return "xml"
    if suffix in YAML_SUFFIXES:
        return "yaml"
    if suffix in (".sh", ".bash") or path.name in (".bashrc", ".profile", ".bash_aliases"):
        return "bash"
    return "markdown" if suffix == ".md" else ""


def check(path: Path, text: str) -> Problem | None:
    """Return the first problem of a text, None if there is none, or no checker for the language."""
    checker = _CHECKERS.get("urdf" if path.suffix.lower() == ".urdf" else language_of(path))
    return checker(text) if checker is not None and text.strip() else None


def _python(text: str) -> Problem | None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(text, "<editor>", "exec", dont_inherit=True)
    except SyntaxError as error:
        return Problem(error.lineno or 1, error.offset or 1, f"{type(error).__name__}: {error.msg}")
    except (ValueError, RecursionError, MemoryError) as error:  # a null byte; nesting too deep
        return Problem(1, 1, f"{type(error).__name__}: {error}")
    return None


def _xml(text: str) -> Problem | None:
    from xml.parsers import expat

    parser = expat.ParserCreate()
    parser.EntityDeclHandler = _refuse_entity
    try:
        parser.Parse(text.encode("utf-8"), True)
    except expat.ExpatError as error:
        return Problem(error.lineno, error.offset + 1, expat.ErrorString(error.code))
    except _Entity:
        return Problem(parser.CurrentLineNumber, 1, "entity definitions are not read here")
    return None


class _Entity(Exception):
    """The text defines an entity, which could expand without end."""


def _refuse_entity(*definition: object) -> None:
    raise _Entity


def _yaml(text: str) -> Problem | None:
    import yaml

    try:
        for _ in yaml.parse(text, Loader=yaml.SafeLoader):
            pass
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line, column = (mark.line + 1, mark.column + 1) if mark is not None else (1, 1)
        return Problem(line, column, error.problem or "YAML")
    except yaml.YAMLError as error:
        return Problem(1, 1, str(error).split("\n")[0])
    return None


def _urdf(text: str) -> Problem | None:
    broken = _xml(text)
    if broken is not None:
        return broken
    from day6_core.ros.robot_check import check_robot

    for diagnostic in check_robot(text).diagnostics:
        if diagnostic.level == "Error":
            return Problem(max(1, diagnostic.line), max(1, diagnostic.column), diagnostic.text)
    return None


_CHECKERS: dict[str, Callable[[str], Problem | None]] = {"python": _python, "xml": _xml, "yaml": _yaml, "urdf": _urdf}
