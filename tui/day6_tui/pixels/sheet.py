"""The cells under a picture: blank, but for texts, which stay text and leave holes in the picture."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from rich.segment import Segment
from rich.style import Style
from textual.geometry import Region

from day6_tui.panes.cells import cell_len

Text = tuple[int, int, str, Style]
"""Column, row, text and style."""


class Sheet:
    """`columns` x `rows` cells in the style `blank`."""

    def __init__(self, columns: int, rows: int, blank: Style) -> None:
        self.columns, self.rows = columns, rows
        self._blank = blank
        self._texts: dict[int, list[Text]] = {}

    def put(self, texts: Sequence[Text]) -> list[int]:
        """Replace the texts; return the rows in which the cells differ now. What would touch another text is left out."""
        before, self._texts = self._texts, {}
        for text in texts:
            column, row, words, _ = text
            end = column + cell_len(words)
            others = self._texts.get(row, [])
            free = all(end < other[0] or column > other[0] + cell_len(other[2]) for other in others)
            if words and 0 <= row < self.rows and column >= 0 and end <= self.columns and free:
                self._texts[row] = sorted([*others, text], key=lambda each: each[0])
        return [row for row in sorted(before.keys() | self._texts.keys()) if before.get(row) != self._texts.get(row)]

    @property
    def holes(self) -> list[Region]:
        """The cells of the texts."""
        return [
            Region(column, row, cell_len(words), 1)
            for row, texts in self._texts.items()
            for column, _, words, _ in texts
        ]

    def line(self, row: int) -> list[Segment]:
        """One row of cells."""
        texts = self._texts.get(row, [])
        segments: list[Segment] = []
        edges = [
            0,
            *(edge for column, _, words, _ in texts for edge in (column, column + cell_len(words))),
            self.columns,
        ]
        for number, (left, right) in enumerate(pairwise(edges)):
            if number % 2:
                _, _, words, style = texts[number // 2]
                segments.append(Segment(words, style))
            elif right > left:
                segments.append(Segment(" " * (right - left), self._blank))
        return segments
