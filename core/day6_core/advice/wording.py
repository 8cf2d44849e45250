"""Fills in what was found: into texts as it is, into commands as words that the shell takes for nothing else."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Mapping
from string import Formatter
from typing import Any

from day6_core.advice.fault import Fault
from day6_core.session.harmless import one_line


def filled_in(text: str, values: Mapping[str, str], fault: Fault | None = None) -> str:
    """Return a card's text with what its pattern found, and the place of the fault."""
    return _fill(text, {name: one_line(value) for name, value in values.items()}, fault)


def at_home(text: str, home: str, separator: str = os.sep) -> str:
    """Return a text with ~ for the home folder, as the prompt shows it: the folder of a desktop may have a long path.

    Within quotation marks it stays: there neither Python nor a shell knows what ~ is. Only on Windows, where the backslashes
    alone made `shlex.quote` set them, it doesn't; the path then goes on with what a shell takes for no such thing.
    """
    home = home.rstrip(separator)
    if not home:
        return text
    if separator == "/":
        return re.sub(rf"(?<![\w./'\"-]){re.escape(home)}(?![\w.-])", "~", text)
    below = rf"(?<![\w./\"-])(?P<quote>'?){re.escape(home)}(?P<path>(?:\\[\w.+-]+)*)(?P=quote)(?![\w.-])"
    return re.sub(below, lambda found: "~" + found["path"].replace("\\", "/"), text)


def command_of(text: str, values: Mapping[str, str]) -> str:
    """Return a card's command with what was found, each as one word; '' if a value could not be typed."""
    if any(not value.isprintable() for value in values.values()):
        return ""
    return _fill(text, {name: shlex.quote(value) for name, value in values.items()}, None)


_WITHOUT_LINE = (
    ("（第 {line} 行）", ""),
    (" (line {line})", ""),
    ("第 {line} 行", "这一行"),
    ("line {line}", "this line"),
    ("Line {line}", "This line"),
)
"""What a text says where no traceback tells the line."""


def without_line(text: str) -> str:
    """Return a text for where no traceback tells the line in the pupil's file."""
    for named, unnamed in _WITHOUT_LINE:
        text = text.replace(named, unnamed)
    return text


def _fill(text: str, values: dict[str, str], fault: Fault | None) -> str:
    if fault is None or not fault.line:
        text = without_line(text)
    place = {"line": str(fault.line) if fault is not None else "", "file": fault.file if fault else ""}
    numbered = [values[str(number)] for number in range(len(values)) if str(number) in values]
    return str(Formatter().vformat(text, numbered, _Values(place | values)))


class _Values(dict[str, Any]):
    """What is not known stays unknown: cards are checked when they are read."""

    def __missing__(self, name: str) -> str:
        return "?"


def sentence(text: str, language: str) -> str:
    """Return a text that begins with a capital letter, where its first word is ours."""
    own = language == "en" and text.partition(" ")[0].isalpha()
    return text[0].upper() + text[1:] if own else text


def with_gaps(text: str) -> str:
    """Return a card's text without any message: … where something would be filled in."""
    return "".join(before + ("…" if name is not None else "") for before, name, _, _ in Formatter().parse(text))
