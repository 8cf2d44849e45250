"""Re-wrapping: the rows of a terminal become whole lines again, and these are folded for another width.

A place is a row's index and a column. Places keep their characters, as cursor, selection and a view that looks back must.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

from day6_core.shell.screen.rows import (
    PLAIN_STYLE,
    Folded,
    Row,
    Run,
    as_row,
    cells_of,
    folded,
    folded_runs,
    going_on,
    row_text,
    runs_of,
    without_end,
)
from day6_core.shell.screen.whole_lines import NOT_COMMON
from day6_core.width import text_width, widths

Place = tuple[int, int]


class Marker:
    """A place that its owner wants to follow. `line` counts from the first line the terminal ever showed."""

    __slots__ = ("__weakref__", "column", "line")

    def __init__(self, line: int, column: int = 0) -> None:
        self.line = line
        self.column = column


class Rewrapped(NamedTuple):
    """Rows for another width, where the cursor is in them, and where the other places are."""

    rows: list[Row]
    cursor: Place
    places: list[Place]


def rewrap(
    rows: Sequence[Row], columns: int, cursor: Place, places: Sequence[Place], *, wraps_next: bool = False
) -> Rewrapped:
    """Fold the lines that `rows` consist of at `columns`.

    The line with the cursor reaches to it, so that what is drawn next comes where it would have come in a window that
    always was of this width. `wraps_next`: the cursor still stands behind the last character of a full row.
    """
    new: list[Row] = []
    wanted = [cursor, *places]
    found = [cursor] * len(wanted)
    waiting = deque(sorted(range(len(wanted)), key=wanted.__getitem__))
    half = columns // 2
    first, count = 0, len(rows)
    while first < count:
        row = rows[first]
        end = first + 1
        if type(row) is str and (len(row) <= half or (len(row) <= columns and row.isascii())):
            made: list[Row] = [row]
        else:
            while end < count and isinstance(rows[end - 1], Folded):
                end += 1
            made = _fold(_joined(rows[first:end]), columns)
        start = len(new)
        while waiting and wanted[waiting[0]][0] < end:
            number = waiting.popleft()
            index, x = wanted[number]
            offset = x + sum(map(row_width, rows[first:index]))
            if index < end - 1:
                offset -= max(x - row_width(rows[index]), 0)
            sticks = not number and wraps_next
            if not number:
                _reach(made, offset, columns, sticks=sticks)
            y, x = _place(made, offset, sticks=sticks)
            found[number] = start + y, min(x, columns)
        new += made
        first = end
    for number in waiting:
        index, x = wanted[number]
        found[number] = len(new) + index - count, min(x, columns)
    return Rewrapped(new, found[0], found[1:])


def row_width(row: Row) -> int:
    """The cells of a row."""
    return text_width(row_text(row))


def _joined(rows: Sequence[Row]) -> Row:
    """The rows of one line as one row."""
    texts = [row for row in rows if isinstance(row, str)]
    if len(texts) == len(rows):
        return "".join(texts).rstrip(" ")
    runs: list[Run] = []
    for row in rows:
        runs += runs_of(row)
    return without_end(tuple(runs))


def _fold(line: Row, columns: int) -> list[Row]:
    text = row_text(line)
    if not text.isascii() and NOT_COMMON.search(text) and "0" in widths(text):
        return _fold_cells(line, columns)
    if isinstance(line, str):
        return list(folded(line, columns))
    return list(map(without_end, folded_runs(line, columns)))


def _fold_cells(line: Row, columns: int) -> list[Row]:
    """Fold a line with characters that take no cell."""
    cells = cells_of(line)
    rows: list[Row] = []
    start = 0
    while True:
        end = start + columns
        if end < len(cells) and cells[end].data == "" and columns > 1:
            end -= 1
        rows.append(as_row(dict(enumerate(cells[start:end])), folded=end < len(cells)))
        if end >= len(cells):
            return rows
        start = end


def _reach(rows: list[Row], offset: int, columns: int, *, sticks: bool) -> None:
    """Lengthen a line so that a cursor has its place in it."""
    rest = offset - sum(map(row_width, rows[:-1]))
    while rest > columns or (rest == columns and not sticks):
        blanks = " " * (columns - row_width(rows[-1]))
        rows[-1] = going_on((*runs_of(rows[-1]), (blanks, PLAIN_STYLE)))
        rows.append("")
        rest -= columns


def _place(rows: Sequence[Row], offset: int, *, sticks: bool) -> Place:
    """The row and column of the cell `offset` of a line."""
    for y, row in enumerate(rows[:-1]):
        width = row_width(row)
        if offset < width or (sticks and offset == width):
            return y, offset
        offset -= width
    return len(rows) - 1, offset
