"""Which part of the graph's picture the window shows: panning, and what lies outside."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from day6_core.ros.programs.rqt_graph.model.shapes import LaidOutGraph, Rect

IN_SIGHT = (8, 2)
"""Columns and rows of the picture that stay in the window, however far one pans."""


class Beyond(NamedTuple):
    """How many boxes lie outside, wholly or in part, by direction; None where the picture does not go on."""

    left: int | None
    right: int | None
    up: int | None
    down: int | None


class Viewport:
    """A window of `columns` x `rows` cells onto a picture; (`x`, `y`) is the cell of the picture at its upper left corner."""

    def __init__(self) -> None:
        self.columns = self.rows = 0
        self.x = self.y = 0
        self._width = self._height = 0

    @property
    def part(self) -> Rect:
        """The part of the picture that is seen; more than the picture where that is smaller."""
        return Rect(self.x, self.y, self.columns, self.rows)

    def show(self, picture: LaidOutGraph, columns: int, rows: int) -> None:
        """Show another picture, or the same one in a window of another size, and stay where that is possible."""
        self.columns, self.rows = columns, rows
        self._width, self._height = picture.width, picture.height
        self.pan(0, 0)

    def centre(self) -> None:
        """Put a picture that fits into the middle, another one to its beginning."""
        self.x = -max(0, (self.columns - self._width) // 2)
        self.y = -max(0, (self.rows - self._height) // 2)

    def pan(self, columns: int, rows: int) -> None:
        """Move the window over the picture."""
        self.x = _between(self.x + columns, self._width, self.columns, IN_SIGHT[0])
        self.y = _between(self.y + rows, self._height, self.rows, IN_SIGHT[1])

    def zoom_to(self, picture: LaidOutGraph, column: int, row: int) -> None:
        """Show the same graph in another form; what is at this cell of the window stays there, as well as it can."""
        across = (self.x + column) / max(1, self._width)
        down = (self.y + row) / max(1, self._height)
        self.show(picture, self.columns, self.rows)
        self.centre()
        if picture.width > self.columns:
            self.x = min(max(0, round(across * picture.width) - column), picture.width - self.columns)
        if picture.height > self.rows:
            self.y = min(max(0, round(down * picture.height) - row), picture.height - self.rows)

    def reveal(self, rect: Rect) -> None:
        """Pan as little as is needed to see a box."""
        right, bottom = rect.x + rect.width - self.columns, rect.y + rect.height - self.rows
        self.pan(max(0, right - self.x) + min(0, rect.x - self.x), max(0, bottom - self.y) + min(0, rect.y - self.y))

    def beyond(self, rects: Iterable[Rect]) -> Beyond:
        """What of the picture lies outside the window."""
        rects = list(rects)
        right, bottom = self.x + self.columns, self.y + self.rows
        return Beyond(
            sum(rect.x < self.x for rect in rects) if self.x > 0 else None,
            sum(rect.x + rect.width > right for rect in rects) if self._width > right else None,
            sum(rect.y < self.y for rect in rects) if self.y > 0 else None,
            sum(rect.y + rect.height > bottom for rect in rects) if self._height > bottom else None,
        )


def _between(place: int, size: int, window: int, least: int) -> int:
    """The place nearest to `place` at which `least` cells of something `size` long are in the window."""
    least = min(least, size, window)
    return min(max(place, least - window), size - least)
