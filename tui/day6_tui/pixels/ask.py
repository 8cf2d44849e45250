"""Asks the terminal what it can draw, and recognises its answers among the keys.

First its name (XTVERSION), the size of a cell and its device attributes (DA1), which every terminal answers: that answer ends the
wait for the others. Kitty's own question is put only to terminals that told their name: others would print it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from textual.message import Message

KITTY, SIXEL, ITERM = "kitty", "sixel", "iterm"

FIRST = "\x1b[>0q\x1b[16t\x1b[14t\x1b[c"
SECOND = "\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[c"
READY = "\x1b[5n"
"""Asked behind a picture: the answer comes when the terminal has drawn it."""
IS_READY = "\x1b[0n"

WINDOWS_TERMINAL_CELL = (10, 20)
"""Pixels of a cell for Sixel in Windows Terminal, at any size of its letters."""

XTERM_JS = frozenset({"62", "4", "9", "22"})
"""The device attributes of xterm.js with pictures (VS Code, browsers). It rounds a cell's size, hardly that of its screen."""

ANSWER = re.compile(
    r"\x1b_G[^\x1b]*\x1b\\"  # Kitty's graphics
    r"|\x1bP>\|[^\x1b]*\x1b\\"  # name and version
    r"|\x1b\[\?[0-9;]*c"  # device attributes
    r"|\x1b\[[46];[0-9]+;[0-9]+t"  # pixels of the text area, of a cell
    r"|\x1b\[0n"
)
_LONGEST = 256
_BEGINNING = re.compile(
    r"\x1b(?:_(?:G[^\x1b]*\x1b?)?|P(?:>(?:\|[^\x1b]*\x1b?)?)?|\[(?:\?[0-9;]*|[46](?:;[0-9]*){0,2}|0)?)?\Z"
)
_CERTAIN = ("\x1b_G", "\x1bP>|", "\x1b[?")
_AREA = re.compile(r"\x1b\[([46]);([0-9]+);([0-9]+)t")


class Answered(Message):
    """The terminal answered a question."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.text = text

    @property
    def closes(self) -> bool:
        """Whether it is the last answer to what was asked in one go."""
        return closes(self.text)


def closes(answer: str) -> bool:
    """Whether nothing more comes for the questions that were sent together."""
    return answer[-1] in "cn"


def beginning(text: str) -> int:
    """Where an answer begins whose end has not arrived; the length of `text` if there is none."""
    found = _BEGINNING.search(text, max(0, len(text) - _LONGEST))
    return found.start() if found else len(text)


def is_certain(held: str) -> bool:
    """Whether this can only be the beginning of an answer: no key sends it."""
    return held.startswith(_CERTAIN)


@dataclass(frozen=True)
class Ability:
    """How the terminal takes pictures, and the pixels of one of its cells: width and height."""

    protocol: str
    cell: tuple[int, int]
    exact: tuple[float, float] | None = None
    """Width and height of a cell where they are no whole pixels, as in a browser."""


def may_be_asked(environ: Mapping[str, str]) -> bool:
    """Whether questions get through: tmux and screen stand between, and simple terminals print what they do not know."""
    term = environ.get("TERM", "")
    between = "TMUX" in environ or "STY" in environ or term.startswith(("tmux", "screen"))
    return not between and term not in ("", "linux", "dumb", "vt100", "vt220")


@dataclass
class Inquiry:
    """What the terminal has answered so far."""

    environ: Mapping[str, str]
    size: tuple[int, int]
    """Columns and rows of the screen."""
    pixels: tuple[int, int] = (0, 0)
    """Width and height of the screen as the system knows them, 0 if it does not."""
    name: str = ""
    cell: tuple[int, int] | None = None
    area: tuple[int, int] | None = None
    """Width and height of the text area in pixels."""
    kitty: bool = False
    attributes: frozenset[str] = field(default_factory=frozenset)
    done: bool = False

    def take(self, answer: str) -> str:
        """Take an answer; return what has to be asked next, '' if nothing."""
        if answer.startswith("\x1bP>|"):
            self.name = answer[4:-2]
        elif answer.startswith("\x1b_Gi=31;"):
            self.kitty = answer.endswith(";OK\x1b\\")
        elif area := _AREA.fullmatch(answer):
            self._take_area(area[1] == "6", int(area[3]), int(area[2]))
        elif answer.endswith("c"):
            first = not self.attributes
            self.attributes = frozenset(answer[3:-1].split(";"))
            if first and self.name:
                return SECOND
            self.done = True
        return ""

    def _take_area(self, of_cell: bool, width: int, height: int) -> None:
        columns, rows = self.size
        if of_cell:
            self.cell = (width, height)
            return
        self.area = (width, height)
        if self.cell is None:
            self.cell = (width // max(1, columns), height // max(1, rows))

    @property
    def ability(self) -> Ability | None:
        """What came out; None if the terminal shows no pictures."""
        cell = self.cell or (self.pixels[0] // max(1, self.size[0]), self.pixels[1] // max(1, self.size[1]))
        known = 2 <= cell[0] <= 256 and 2 <= cell[1] <= 256
        iterm = self.name.startswith("iTerm2") or self.environ.get("TERM_PROGRAM") == "iTerm.app"
        if self.kitty:
            return Ability(KITTY, cell if known else (10, 20))
        if iterm:
            return Ability(ITERM, cell if known else (10, 20))
        return Ability(SIXEL, cell, self._exact(cell)) if "4" in self.attributes and known else None

    def _exact(self, cell: tuple[int, int]) -> tuple[float, float] | None:
        """The size of a cell where it is no whole number of pixels, else None."""
        if self.area is None or self.attributes != XTERM_JS:
            return None
        exact = (self.area[0] / max(1, self.size[0]), self.area[1] / max(1, self.size[1]))
        near = all(abs(whole - part) < 1 for whole, part in zip(cell, exact, strict=True))
        return exact if near and exact != cell else None
