"""The text of a terminal whose window changes its size: it is folded anew; lines go up into the scrollback and come back."""

from __future__ import annotations

from collections import deque

from day6_core.shell.screen import text as text_module
from day6_core.shell.screen.reflow import Marker, rewrap
from day6_core.shell.screen.rows import Row, ended, fit
from day6_core.shell.screen.text import ScreenText


class SizedText(ScreenText):
    """The text in a window."""

    def __init__(self, columns: int, lines: int) -> None:
        super().__init__(columns, lines)
        self._cleared = 0
        """`scrolled` when the screen was last cleared: growing brings back no line from before."""
        self._widest = columns
        self._below: list[Row] = []
        """The last line, and those under it that a lower window has no room for because its cursor stands so high."""
        self._below_since = 0
        """`scrolled` when they were there: any line that scrolls forgets them."""

    def resize(self, lines: int | None = None, columns: int | None = None) -> None:
        """Change the size of the window."""
        lines = lines or self.lines
        columns = columns or self.columns
        if (lines, columns) == (self.lines, self.columns):
            return
        self._settle()
        self.tabstops = set(range(8, columns, 8))
        if self.keeps_history:
            self._rearrange(lines, columns)
        else:
            self._crop(lines, columns)
        self.margins = None

    def _crop(self, lines: int, columns: int) -> None:
        """Cut the text of a full-screen program, which draws anew: at the top, and at the right."""
        surplus = max(0, self.lines - lines)
        kept = {y - surplus: line for y, line in self._buffer.items() if y >= surplus}
        self._buffer.clear()
        self._buffer.update(kept)
        for line in self._buffer.values():
            fit(line, columns)
            line.folded &= columns >= self.columns
        self.lines, self.columns = lines, columns
        self.cursor.x, self.cursor.y = min(self.cursor.x, columns), min(self.cursor.y, lines - 1)
        self.dirty.clear()
        self.dirty.update(range(lines))

    def _rearrange(self, lines: int, columns: int) -> None:
        """Spread scrollback and screen over a window of another size."""
        cursor = self.cursor
        history = len(self._scrollback)
        oldest = self._scrolled - history
        screen = [self.row(y) for y in range(self.lines)]
        below = self._below if self._below_since == self._scrolled else []
        if below and ended(below[0]) == screen[-1]:
            screen[-1] = below[0]
        used = self.lines if below else max([cursor.y, *(y for y, row in enumerate(screen) if row)]) + 1
        rows = [*self._scrollback, *screen[:used], *below[1:]]
        saved = None
        if self.saved is not None:
            saved = Marker(self._scrolled + self.saved.cursor.y, self.saved.cursor.x)
        top, first = history, max(self._cleared - oldest, 0)
        place = history + cursor.y, cursor.x
        if columns != self.columns:
            markers = [marker for marker in self.markers if marker.line >= oldest] + ([saved] if saved else [])
            places = [(top, 0), (first, 0), *((marker.line - oldest, marker.column) for marker in markers)]
            wraps_next = cursor.x >= self.columns
            rows, place, ((top, _), (first, _), *moved) = rewrap(rows, columns, place, places, wraps_next=wraps_next)
            for marker, (index, x) in zip(markers, moved, strict=True):
                marker.line, marker.column = oldest + index, x
        end = len(rows) - lines
        top = min(max(end, first if used == self.lines else top), place[0])
        self._scrollback = deque(rows[:top], maxlen=self._most_above(lines, columns))
        self._scrolled = oldest + top
        self._cleared = oldest + first
        self._below = rows[top + lines - 1 :] if end > top else []
        self._below_since = self._scrolled
        self._buffer.clear()
        for y, row in enumerate(rows[top : top + lines]):
            if row:
                self.fill(y, row)
        self.lines, self.columns = lines, columns
        cursor.y, cursor.x = place[0] - top, min(place[1], columns)
        if self.saved is not None and saved is not None:
            self.saved.cursor.y, self.saved.cursor.x = max(saved.line - self._scrolled, 0), saved.column
        if self._below:
            self.cut(lines)
        self.dirty.clear()
        self.dirty.update(range(lines))

    def _most_above(self, lines: int, columns: int) -> int:
        """The rows of scrollback in which the text of the widest window has room."""
        self._widest = max(self._widest, columns)
        if columns == self._widest:
            return text_module.SCROLLBACK
        return (text_module.SCROLLBACK + max(lines, self.lines)) * -(-self._widest // max(columns - 1, 1))
