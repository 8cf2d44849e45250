"""Lines of a terminal as rows of styled text or of cells, with care for wide characters.

A wide character takes two cells; the second holds an empty string, as xterm has it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby, repeat
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple, overload
from unicodedata import normalize

from day6_core.shell.screen.cells import BLANK, HALF, Cells, Char
from day6_core.width import char_width, fitting, is_mark, widths

if TYPE_CHECKING:
    from day6_core.shell.screen.cells import Line


class Style(NamedTuple):
    """The style of a run of text. Colours are 'default', names ('red', 'brightblue', 'brown' for yellow) or 'rrggbb'."""

    fg: str = "default"
    bg: str = "default"
    bold: bool = False
    italics: bool = False
    underscore: bool = False
    strikethrough: bool = False
    reverse: bool = False
    blink: bool = False


Run = tuple[str, Style]
Row = str | tuple[Run, ...]
"""A line: plain text in the default style, or runs. Without the blanks at its end."""


class Folded:
    """A row whose text goes on in the next one, because it came to the right edge. It has the blanks at its end."""

    __slots__ = ()


class FoldedText(Folded, str):
    __slots__ = ()


class FoldedRuns(Folded, tuple[Run, ...]):
    __slots__ = ()


PLAIN_STYLE = Style()

MOST_MARKS = 8
"""Marks kept on one character."""


class Scrollback(Sequence["CellRow"]):
    """The scrollback of a screen as a sequence of rows of cells, for a view that draws cells; made on demand."""

    def __init__(self, rows: Sequence[Row]) -> None:
        self._rows = rows

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, index: int) -> CellRow: ...
    @overload
    def __getitem__(self, index: slice) -> list[CellRow]: ...
    def __getitem__(self, index: int | slice) -> CellRow | list[CellRow]:
        if isinstance(index, slice):
            return [CellRow(row) for row in list(self._rows)[index]]
        return CellRow(self._rows[index])


class CellRow:
    """A line of the scrollback, cell by cell like a line of the screen: beyond its end there are blanks."""

    def __init__(self, row: Row) -> None:
        self._cells = cells_of(row)

    def __getitem__(self, x: int) -> Char:
        return self._cells[x] if x < len(self._cells) else BLANK


def _mend(line: Line, columns: int) -> None:
    """Blank every half of a wide character whose other half is gone."""
    for x in [x for x, cell in line.items() if cell.data == "" and not _is_wide(line.get(x - 1))]:
        line[x] = BLANK
    for x in [
        x for x, cell in line.items() if _is_wide(cell) and (x + 1 >= columns or line.get(x + 1, BLANK).data != "")
    ]:
        line[x] = BLANK


def fit(line: Line, columns: int) -> None:
    """Cut a line off at the right edge."""
    for x in [x for x in line if x >= columns]:
        del line[x]
    _mend(line, columns)


def _is_wide(cell: Char | None) -> bool:
    return cell is not None and cell.data != "" and cell.data[0] > "\u02ff" and char_width(cell.data[0]) == 2


def folded(text: str, columns: int) -> list[str]:
    """Split a text without zero-width characters into the rows it takes on a screen of that width; at least one row."""
    if text.isascii():
        if len(text) <= columns:
            return [text]
        last = (len(text) - 1) // columns * columns
        return [*[FoldedText(text[at : at + columns]) for at in range(0, last, columns)], text[last:]]
    digits = widths(text)
    rows: list[str] = []
    start, end = 0, len(text)
    while True:
        stop = start + max(fitting(digits, start, columns), 1)
        if stop >= end:
            return [*rows, text[start:]]
        rows.append(FoldedText(text[start:stop]))
        start = stop


def in_style(rows: Sequence[str], style: Style) -> Sequence[Row]:
    """Rows of text in that style."""
    if style == PLAIN_STYLE:
        return rows
    return ["" if not row else ((row, style),) if type(row) is str else FoldedRuns(((row[:], style),)) for row in rows]


def folded_runs(runs: Sequence[Run], columns: int) -> list[Row]:
    """Split styled text into the rows it takes on a screen of that width."""
    rows: list[Row] = []
    row: list[Run] = []
    used = 0
    for text, style in runs:
        digits = "" if text.isascii() else widths(text)
        start, end = 0, len(text)
        while start < end:
            room = max(columns - used, 0)
            count = fitting(digits, start, room) if digits else min(room, end - start)
            if not count:
                if row:
                    rows.append(FoldedRuns(row))
                row, used = [], 0
                count = max(fitting(digits, start, columns), 1) if digits else min(columns, end - start)
            row.append((text[start : start + count], style))
            used += count + digits.count("2", start, start + count)
            start += count
    return [*rows, tuple(row)]


def without_end(row: Row) -> Row:
    """A row as the scrollback keeps it: without trailing blanks, runs of equal style joined."""
    if type(row) is str:
        return row.rstrip(" ")
    if isinstance(row, str):
        return row
    return _row_of(joined_runs(row), folded=type(row) is FoldedRuns)


def joined_runs(row: Iterable[Run]) -> list[Run]:
    """Runs of which no two neighbours have the same style."""
    runs: list[Run] = []
    for text, style in row:
        if runs and runs[-1][1] == style:
            runs[-1] = (runs[-1][0] + text, style)
        elif text:
            runs.append((text, style))
    return runs


def going_on(row: Row) -> Row:
    """The row marked as one whose text goes on in the next one."""
    return _row_of(joined_runs(runs_of(row)), folded=True)


def ended(row: Row) -> Row:
    """The row without that mark."""
    return without_end(row[:]) if isinstance(row, Folded) else row


def combined(cell: Char, char: str) -> Char:
    """Combine a cell with a zero-width character; return the cell alone if that isn't a mark, or is one too many."""
    data = with_mark(cell.data, char)
    return cell if data is cell.data else cell._replace(data=data)


def with_mark(data: str, char: str) -> str:
    """Combine the text of a cell with a mark; return it alone if `char` isn't one, or is one too many."""
    if not is_mark(char) or len(data) > MOST_MARKS:
        return data
    return normalize("NFC", data + char)


def cell_texts(text: str, digits: str) -> Sequence[str]:
    """What stands in each cell of a text whose widths are `digits` ('' if all are 1); `HALF` is behind a wide character."""
    if not digits.strip("1"):
        return text
    cells: list[str] = []
    for char, digit in zip(text, digits, strict=True):
        if digit != "0":
            cells.append(char)
            if digit == "2":
                cells.append(HALF)
        elif cells:
            base = -2 if cells[-1] == HALF else -1
            cells[base] = with_mark(cells[base], char)
    return cells


def cells_of(row: Row) -> list[Char]:
    cells: list[Char] = []
    for text, style in runs_of(row):
        digits = "" if text.isascii() else widths(text)
        first = len(digits) - len(digits.lstrip("0"))
        for mark in text[:first]:  # goes onto a character of another style
            base = -2 if cells and cells[-1].data == "" else -1
            if cells:
                cells[base] = combined(cells[base], mark)
        made = Cells(Char(" ", *style))
        cells += map(made.__getitem__, cell_texts(text[first:], digits[first:]))
    return cells


_STYLE = itemgetter(*range(1, len(BLANK)))


def as_row(line: Mapping[int, Char], *, folded: bool = False) -> Row:
    """Cells by their column as runs of equal style; without the blanks at the end, if the text doesn't go on."""
    if not line:
        return ""
    last = max(line)
    cells = list(map(line.get, range(last + 1), repeat(BLANK)))
    data, *attributes = zip(*cells, strict=True)
    if all(each.count(each[0]) == len(cells) for each in attributes):  # most lines
        runs = [("".join(data), Style(*cells[0][1:]))]
    else:
        runs = [("".join(cell.data for cell in group), Style(*style)) for style, group in groupby(cells, _STYLE)]
    return _row_of(runs, folded=folded)


def _row_of(runs: list[Run], *, folded: bool = False) -> Row:
    if folded:
        return FoldedText(runs[0][0]) if len(runs) == 1 and runs[0][1] == PLAIN_STYLE else FoldedRuns(runs)
    while runs and runs[-1][1] == PLAIN_STYLE:
        stripped = runs[-1][0].rstrip(" ")
        if stripped:
            runs[-1] = (stripped, PLAIN_STYLE)
            break
        runs.pop()
    if not runs:
        return ""
    if len(runs) == 1 and runs[0][1] == PLAIN_STYLE:
        return runs[0][0]
    return tuple(runs)


def runs_of(row: Row) -> tuple[Run, ...]:
    """A row as runs of styled text."""
    return ((row[:], PLAIN_STYLE),) if isinstance(row, str) else row


def row_text(row: Row) -> str:
    """A line without its styles."""
    return row if isinstance(row, str) else "".join(text for text, _ in row)
