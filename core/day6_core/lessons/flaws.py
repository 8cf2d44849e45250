"""What is wrong with something in a teacher's file, in words that say what to do, and the line in which it stands."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from typing import Any

MOST_NAMED = 12
"""Names that are listed where none is near."""


class MarkedMap(dict[str, Any]):
    """A mapping of a YAML text with the line (from 1) of each key; `broken`: the text was no YAML, so nothing is known of it."""

    line = 0
    broken = False

    def __init__(self) -> None:
        super().__init__()
        self.lines: dict[str, int] = {}


class MarkedList(list[Any]):
    """A list of a YAML text with the line of each item."""

    line = 0

    def __init__(self) -> None:
        super().__init__()
        self.lines: dict[int, int] = {}


class Flaw(str):
    """A mistake; `line` is 0 where it is not known."""

    line: int

    def __new__(cls, text: str, line: int = 0) -> Flaw:
        made = super().__new__(cls, text)
        made.line = line
        return made

    def of(self, what: str, line: int = 0) -> Flaw:
        """This flaw as one of `what`; `line` is used where no closer one is known."""
        return Flaw(f"{what}: {self}", self.line or line)


def line_of(where: object, key: object = None) -> int:
    """The line of a key or an item, that of the whole without `key`; 0 where the thing came from no file."""
    if isinstance(where, (MarkedMap, MarkedList)):
        lines: dict[Any, int] = where.lines
        return lines.get(key, where.line)
    return 0


def meant(word: object, known: Iterable[str]) -> str:
    """The end of a message about an unknown name: the nearest known one, or what there is."""
    names = list(known)
    near = get_close_matches(str(word), names, 1)
    if near:
        return f"; did you mean '{near[0]}'?"
    shown = ", ".join(names[:MOST_NAMED])
    return f"; there are {shown}" + (" …" if len(names) > MOST_NAMED else "")


def path_flaw(path: str) -> str:
    """What is wrong with the path of a file or folder in a lesson; '' if nothing is."""
    if path == "~" or (path.startswith("~/") and ".." not in path.split("/") and "\0" not in path):
        return ""
    return f"'{path}' has to lie in the home folder: write ~/{path.strip('./~').rpartition('/')[2] or 'FILE'}"
