"""The cells of a terminal: a character with its colours and attributes, and lines of them."""

from __future__ import annotations

from typing import NamedTuple


class Char(NamedTuple):
    """A cell. The second cell of a wide character holds ''. Colours as in `rows.Style`."""

    data: str
    fg: str = "default"
    bg: str = "default"
    bold: bool = False
    italics: bool = False
    underscore: bool = False
    strikethrough: bool = False
    reverse: bool = False
    blink: bool = False


BLANK = Char(" ")

HALF = "\0"
"""Stands for the second cell of a wide character in a text that has a character for each cell: no text has it."""


class Line(dict[int, Char]):
    """The cells of a line that were drawn, by their column; a blank where another one is asked for."""

    __slots__ = ("blank", "folded")

    def __init__(self, blank: Char = BLANK) -> None:
        self.blank = blank
        self.folded = False
        """Whether its text goes on in the next line, because it came to the right edge."""

    def __missing__(self, x: int) -> Char:
        return self.blank


class ScreenLines(dict[int, Line]):
    """The lines of a screen that were drawn in, by their row; an empty one is made where another one is asked for."""

    def __init__(self) -> None:
        self.blank = BLANK

    def __missing__(self, y: int) -> Line:
        line = self[y] = Line(self.blank)
        return line


class Cells(dict[str, Char]):
    """The cells of one style by their characters (or `HALF`), each made once."""

    def __init__(self, attrs: Char) -> None:
        self._style = attrs[1:]

    def __missing__(self, data: str) -> Char:
        if len(self) > 4096:
            self.clear()
        cell = Char("" if data == HALF else data, *self._style)
        self[data] = cell
        return cell
