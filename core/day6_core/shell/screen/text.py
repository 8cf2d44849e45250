"""The text of a terminal: the lines on its screen, those above it, and those that are on their way.

Scrolling text costs little, because a line that leaves the screen is never drawn cell by cell: what scrolls in queues up below
the screen as rows, and plain text in the last line is kept as characters. Both become cells when somebody asks for `buffer` or
`scrollback`. A row that goes on in the next one is marked (`Folded`, `Line.folded`), so that another width folds the text anew.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from weakref import WeakSet

from day6_core.shell.screen.cells import Cells, Char, Line, ScreenLines
from day6_core.shell.screen.pen import Pen
from day6_core.shell.screen.reflow import Marker
from day6_core.shell.screen.rows import (
    PLAIN_STYLE,
    Folded,
    FoldedText,
    Row,
    as_row,
    cell_texts,
    cells_of,
    ended,
    row_text,
    runs_of,
    without_end,
)
from day6_core.shell.screen.vt import Vt
from day6_core.width import widths

SCROLLBACK = 5000
"""Lines kept above the screen, while it is as wide as it ever was; a narrower one needs more for the same text."""

MOST_ARRIVING = 512
"""Rows that queue up below the screen after a text was fed."""


class ScreenText(Vt):
    """The text of a terminal. `keeps_history` says whether lines that leave the screen are kept above it."""

    def __init__(self, columns: int, lines: int) -> None:
        super().__init__(columns, lines)
        self.keeps_history = True
        self.markers: WeakSet[Marker] = WeakSet()
        """Places that follow their text when it is wrapped anew."""
        self._buffer = ScreenLines()
        self._scrollback: deque[Row] = deque(maxlen=SCROLLBACK)
        self._scrolled = 0
        self._arriving: list[Row | Line | None] = []
        """Rows above the one with the cursor that have not moved into the screen yet; a line that left it is one of cells."""
        self._passed = 0
        """Rows that went by before those and are not even kept in the scrollback."""
        self._is_full = False
        """Whether those fill the screen, and the scrollback has all that came before them."""
        self.pen = Pen()
        """The last line, while it is plain text and no line of cells yet."""
        self._cells: dict[tuple[object, ...], Cells] = {}

    # -- reading -------------------------------------------------------------------------------------------------------

    @property
    def buffer(self) -> ScreenLines:
        """The lines of cells on the screen, by their row."""
        if self._arriving or self.pen:
            self._settle()
        return self._buffer

    @property
    def scrollback(self) -> deque[Row]:
        """The lines above the screen, the oldest first."""
        if self._arriving:
            self._settle()
        return self._scrollback

    @property
    def scrolled(self) -> int:
        """Lines that ever left the screen at the top; a view that is scrolled back uses it to stay where it is."""
        if self._arriving:
            self._settle()
        return self._scrolled

    def row(self, y: int) -> Row:
        """Line `y` of the screen, 0 at the top."""
        return row_of(self.buffer.get(y))

    def history_row(self, index: int) -> Row:
        """Line `index` of the scrollback, 0 the oldest."""
        return self.scrollback[index]

    @property
    def text(self) -> str:
        """The screen as plain lines without blanks at their ends."""
        return "\n".join(row_text(self.row(y)).rstrip(" ") for y in range(self.lines)).rstrip()

    # -- what scrolls in -----------------------------------------------------------------------------------------------

    def arrive(self, rows: Sequence[Row]) -> None:
        """Rows that scroll in from below, above the line with the cursor."""
        surplus = len(rows) - (self._scrollback.maxlen or 0) - self.lines
        if surplus > 0:
            self._settle()
            self._passed += surplus
        self._arriving += rows[surplus:] if surplus > 0 else rows

    def is_at_the_empty_end(self) -> bool:
        """Whether the cursor stands in a last line that nothing was drawn in, so that rows can arrive above it."""
        bottom = self.lines - 1
        return self.cursor.y == bottom and not self.pen and not self._buffer.get(bottom) and not self.margins

    def goes_on(self) -> bool:
        """Whether the last line is what the one above it goes on with: erasing it says something about that one, too."""
        if self._arriving:
            last = self._arriving[-1]
            return last.folded if isinstance(last, Line) else isinstance(last, Folded)
        if self.lines > 1:
            above = self._buffer.get(self.lines - 2)
            return above is not None and above.folded
        return bool(self._scrollback) and isinstance(self._scrollback[-1], Folded)

    def push_up(self) -> None:
        """Have the last line scroll up, whatever it consists of; a new one is below it."""
        if not self._arriving:
            self.dirty.update(range(self.lines))
        if self.pen:
            self._arriving.append(self.pen.lift())
        else:
            self._arriving.append(self._buffer.pop(self.lines - 1, ""))

    def cut(self, y: int) -> None:
        """Line `y` is no longer what the line above it goes on with."""
        if y == self.lines - 1 and self._arriving:
            last = self._arriving[-1]
            if isinstance(last, Line):
                last.folded = False
            elif last is not None:
                self._arriving[-1] = ended(last)
        elif y:
            above = self.buffer.get(y - 1)
            if above is not None:
                above.folded = False
        elif self.keeps_history and self.scrollback:
            self._scrollback[-1] = ended(self._scrollback[-1])

    def _make_room(self) -> None:
        """Let the rows that queued up below and are not on the screen any more go into the scrollback, without drawing any."""
        bottom = self.lines - 1
        if not bottom or self._passed or len(self._arriving) <= bottom:
            self._settle()
            return
        if not self._is_full:
            self._remember_all([self._buffer.pop(y, None) for y in range(bottom)])
            self._is_full = True
        self._remember_all(self._arriving[:-bottom])
        del self._arriving[:-bottom]

    def _settle(self) -> None:
        """Let the rows that queued up below move into the screen, and what they push out into the scrollback."""
        if self.pen:
            self._lay_pen_down()
        if not self._arriving and not self._passed:
            return
        arriving, self._arriving = self._arriving, []
        passed, self._passed = self._passed, 0
        buffer, bottom = self._buffer, self.lines - 1
        current = buffer.pop(bottom, None)
        above = [] if self._is_full else [buffer.pop(y, None) for y in range(bottom)]
        self._is_full = False
        if passed:  # between what was here and what arrives
            self._remember_all(above)
            self._scrolled += passed
            above = []
        rows = above + arriving
        kept = rows[len(rows) - bottom :] if bottom else []
        self._remember_all(rows[: len(rows) - len(kept)])
        for y, row in enumerate(kept, bottom - len(kept)):
            if isinstance(row, dict):
                buffer[y] = row
            elif row:
                self.fill(y, row)
        if current is not None:
            buffer[bottom] = current
        self.dirty.update(range(self.lines))

    def _lay_pen_down(self) -> None:
        """Turn the last line into one of cells."""
        cells = self.cells_in(Char(" ", *PLAIN_STYLE))
        self._buffer[self.lines - 1].update(enumerate(map(cells.__getitem__, self.pen.cells())))
        self.pen = Pen()

    def _remember_all(self, rows: Sequence[Row | Line | None]) -> None:
        if not self.keeps_history:
            return
        self._scrolled += len(rows)
        self._scrollback += [
            row if type(row) is FoldedText else row_of(row) if isinstance(row, dict) else without_end(row or "")
            for row in rows[-(self._scrollback.maxlen or 0) :]
        ]

    # -- cells ---------------------------------------------------------------------------------------------------------

    def line(self) -> Line:
        """The line of cells with the cursor: the last of the screen stands still, whatever arrives above it."""
        y = self.cursor.y
        if y != self.lines - 1:
            return self.buffer[y]
        if self.pen:
            self._lay_pen_down()
        return self._buffer[y]

    def cells_in(self, attrs: Char) -> Cells:
        """The cells that have these attributes."""
        style = attrs[1:]
        cells = self._cells.get(style)
        if cells is None:
            if len(self._cells) > 256:
                self._cells.clear()
            cells = self._cells[style] = Cells(attrs)
        return cells

    def fill(self, y: int, row: Row) -> None:
        """Make the cells of a row of the screen."""
        line = self._buffer[y]
        line.folded = isinstance(row, Folded)
        x = 0
        for text, style in runs_of(row):
            digits = "" if text.isascii() else widths(text)
            if digits[:1] == "0":  # a mark on a character of another style
                line.update(enumerate(cells_of(row)))
                return
            x = fill_cells(line, x, text, digits, self.cells_in(Char(" ", *style)))


def row_of(line: Line | None) -> Row:
    """A line of cells as a row."""
    return as_row(line, folded=line.folded) if line else ""


def fill_cells(line: Line, x: int, text: str, digits: str, cells: Cells) -> int:
    """Put characters into a line of cells; returns the place after them. `digits` are their widths, '' if all are 1."""
    parts = cell_texts(text, digits)
    end = x + len(parts)
    line.update(zip(range(x, end), map(cells.__getitem__, parts)))  # noqa: B905
    return end
