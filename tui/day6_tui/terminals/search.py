"""Finding a text in what a terminal shows and has shown: over lines that were wrapped, in small and capital letters."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator
from itertools import accumulate
from typing import TYPE_CHECKING

from day6_core.width import text_width

if TYPE_CHECKING:
    from day6_tui.terminals.view import Selection, TerminalView


class TerminalSearch:
    """Looks for one text in one terminal, each time anew. Capitals in it count; without any, small and capital are equal."""

    def __init__(self, view: TerminalView, wanted: str) -> None:
        self.view = view
        self.wanted = wanted
        capitals = any(char.isupper() for char in wanted)
        self._pattern = re.compile(re.escape(wanted), 0 if capitals else re.IGNORECASE)

    def found(self) -> list[Selection]:
        """Every place with the text, from the oldest line down, as a selection of the view."""
        places: list[Selection] = []
        if self.wanted:
            for first, parts in self._lines():
                starts = list(accumulate(map(len, parts), initial=0))[:-1]
                for match in self._pattern.finditer("".join(parts)):
                    line, column = _cell(parts, starts, match.start())
                    last, end = _cell(parts, starts, match.end() - 1, after=True)
                    places.append(((first + line, column), (first + last, end)))
        return places

    def next(self, after: Selection | None = None) -> Selection | None:
        """The place that follows the one given, the first one after the last; None if the text is nowhere."""
        places = self.found()
        if not places:
            return None
        later = [] if after is None else [place for place in places if place[0] > after[0]]
        return (later or places)[0]

    def previous(self, before: Selection | None = None) -> Selection | None:
        """The place above the one given, the last one before the first; None if the text is nowhere."""
        places = self.found()
        if not places:
            return None
        earlier = [] if before is None else [place for place in places if place[0] < before[0]]
        return (earlier or places)[-1]

    def show(self, place: Selection) -> None:
        """Select a place, and look there if it isn't in sight."""
        view = self.view
        view.selection = place
        line, top = place[0][0], view.history - view.scroll
        if not top <= line < top + view.lines:
            view.scroll_by(top - max(line - view.lines // 2, 0))

    def _lines(self) -> Iterator[tuple[int, list[str]]]:
        """The lines of text: the first row of each, and the texts of all its rows."""
        from day6_core.shell.screen.rows import Folded, row_text

        screen = self.view.terminal.screen
        first, parts = 0, []
        for number, row in enumerate([*screen.scrollback, *map(screen.row, range(screen.lines))], 1):
            parts.append(row_text(row))
            if not isinstance(row, Folded):
                yield first, parts
                first, parts = number, []
        if parts:
            yield first, parts


def _cell(parts: list[str], starts: list[int], index: int, *, after: bool = False) -> tuple[int, int]:
    """The row and column of a character of a line, or the column after it."""
    row = bisect_right(starts, index) - 1
    end = index - starts[row] + after
    while after and end < len(parts[row]) and not text_width(parts[row][end]):
        end += 1
    return row, text_width(parts[row][:end])
