"""One line of the report of `day6-tui doctor`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

LEVELS = ("ok", "note", "problem")


class Line(NamedTuple):
    """What was found, as the key of a text with its values; a problem also says what to do."""

    level: str
    key: str
    values: Mapping[str, object]
    todo: str = ""
    """The key of a text."""


def ok(key: str, **values: object) -> Line:
    """Something is as it should be."""
    return Line("ok", key, values)


def note(key: str, todo: str = "", **values: object) -> Line:
    """Something to know."""
    return Line("note", key, values, todo)


def problem(key: str, todo: str, **values: object) -> Line:
    """Something that keeps day6-tui from working as it should."""
    return Line("problem", key, values, todo)
