"""A grid of terminal cells to draw text on; wide characters take two cells."""

from __future__ import annotations

import math
import unicodedata
from functools import lru_cache
from itertools import groupby
from operator import itemgetter

Style = str | tuple[int, int]
"""The name of a style, or two colours 0xRRGGBB (-1: the terminal's own): of the characters, and of what is behind them."""
Run = tuple[str, Style]
"""Text and its style."""
Row = list[Run]


def cell_width(text: str) -> int:
    """Return the number of terminal cells of a text: two for each Chinese character, none for combining marks."""
    return sum(_width(character) for character in text)


@lru_cache(maxsize=4096)
def _width(character: str) -> int:
    if unicodedata.combining(character) or unicodedata.category(character) in ("Cf", "Mn", "Me"):
        return 0
    return 2 if unicodedata.east_asian_width(character) in ("W", "F") else 1


class Canvas:
    """`height` rows of `width` cells. Anything drawn outside is clipped."""

    def __init__(self, width: int, height: int) -> None:
        self.width = max(width, 0)
        self.height = max(height, 0)
        # A cell has a text ('' for the second half of a wide character) and a style.
        self._cells: list[list[Run]] = [[(" ", "")] * self.width for _ in range(self.height)]

    def put(self, column: int, row: int, character: str, style: Style) -> None:
        """Set one cell to a narrow character."""
        if 0 <= row < self.height and 0 <= column < self.width:
            self._clear_wide(column, row)
            self._cells[row][column] = (character, style)

    def text(self, column: int, row: int, text: str, style: Style) -> None:
        """Write text from a cell to the right; characters that do not fit completely are omitted."""
        if not 0 <= row < self.height:
            return
        for character in text:
            width = _width(character)
            if column >= 0 and column + width <= self.width and width:
                for part in range(width):
                    self._clear_wide(column + part, row)
                self._cells[row][column] = (character, style)
                if width == 2:
                    self._cells[row][column + 1] = ("", style)
            column += width

    def is_free(self, column: int, row: int, width: int) -> bool:
        """Return whether `width` cells from this one on are all inside the grid and blank."""
        if not 0 <= row < self.height or column < 0 or column + width > self.width:
            return False
        return all(text == " " for text, _ in self._cells[row][column : column + width])

    def box(self, left: int, top: int, right: int, bottom: int, lines: str, style: Style) -> None:
        """Draw a rectangle; `lines` are its four corners row by row, then the horizontal and the vertical line."""
        for column in range(max(left, 0), min(right, self.width - 1) + 1):
            self.put(column, top, lines[4], style)
            self.put(column, bottom, lines[4], style)
        for row in range(max(top, 0), min(bottom, self.height - 1) + 1):
            self.put(left, row, lines[5], style)
            self.put(right, row, lines[5], style)
        for character, (column, row) in zip(
            lines[:4], ((left, top), (right, top), (left, bottom), (right, bottom)), strict=True
        ):
            self.put(column, row, character, style)

    def line(self, column: int, row: int, to_column: int, to_row: int, lines: str, style: Style) -> None:
        """Draw a straight line with the character closest to its slope."""
        across, down = to_column - column, to_row - row
        steps = max(abs(across), abs(down))
        if abs(across) > 3 * abs(down):
            character = lines[4]
        elif abs(across) * 2 < abs(down):
            character = lines[5]
        else:
            character = "\\" if across * down > 0 else "/"
        part = (0.0, 1.0)
        if steps > 4 * (self.width + self.height):  # most of it is outside
            inside = visible_part((column, row), (to_column, to_row), self.width, self.height)
            if inside is None:
                return
            part = inside
        for step in range(math.floor(part[0] * steps), math.ceil(part[1] * steps) + 1):
            share = step / steps if steps else 0.0
            self.put(round(column + share * across), round(row + share * down), character, style)

    def rows(self) -> list[Row]:
        """Return every row as runs of equal style; their texts together take exactly `width` cells."""
        return [_runs(cells) for cells in self._cells]

    def _clear_wide(self, column: int, row: int) -> None:
        """Blank the other half of a wide character in a cell that is about to be overwritten."""
        cells = self._cells[row]
        if cells[column][0] == "" and column > 0:
            cells[column - 1] = (" ", cells[column - 1][1])
            cells[column] = (" ", cells[column][1])
        elif column + 1 < self.width and cells[column + 1][0] == "":
            cells[column + 1] = (" ", cells[column + 1][1])


def visible_part(
    start: tuple[float, float], end: tuple[float, float], width: float, height: float
) -> tuple[float, float] | None:
    """From and to which share of its length a straight line is in a picture; None if it never is (Liang and Barsky)."""
    (x, y), (dx, dy) = start, (end[0] - start[0], end[1] - start[1])
    first, last = 0.0, 1.0
    for way, room in ((-dx, x), (dx, width - x), (-dy, y), (dy, height - y)):
        if way == 0:
            if room < 0:
                return None
        elif way < 0:
            first = max(first, room / way)
        else:
            last = min(last, room / way)
    return (first, last) if first <= last else None


def _runs(cells: list[Run]) -> Row:
    return [("".join(text for text, _ in run), style) for style, run in groupby(cells, itemgetter(1))]
