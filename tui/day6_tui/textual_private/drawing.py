"""Draws what Textual wants drawn: only what differs from what the terminal shows, and on a slow line only as much as it takes.

What is not sent stays dirty in the compositor, and is sent later as it is then: so nothing old ever comes after something newer,
and no cell is forgotten. First come the cells around the cursor, then the rest of the widget with the keyboard, then what has
waited longest.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from rich.color import ColorSystem
from textual._compositor import ChopsUpdate, CompositorUpdate, LayoutUpdate
from textual.geometry import Offset, Region, Size
from textual.strip import Strip

from day6_tui.screen.line import Line
from day6_tui.screen.shown import Shown, Span
from day6_tui.textual_private.dirty_spans import pieces_of_chops
from day6_tui.textual_private.frame_screen import SpansUpdate

if TYPE_CHECKING:
    from rich.console import Console
    from rich.style import Style

Piece = tuple[int, int, Strip]
"""Column and line of a strip."""

HEAD_START = 1.0
"""Seconds that the widget with the keyboard seems to have waited longer than others."""
FOR_KEYS = 2.0
"""How much more may be under way where it is for cells around the cursor."""


class PreparedUpdate(CompositorUpdate):
    """An update as it is sent."""

    def __init__(self, text: str, spans: Sequence[Span]) -> None:
        self.spans = spans
        self._text = text

    def render_segments(self, console: Console) -> str:
        """The sequences for a terminal."""
        return self._text


class Drawing:
    """What one terminal shows, and what still has to be sent to it."""

    def __init__(self, line: Line, clock: Callable[[], float] = time.monotonic) -> None:
        self.shown = Shown()
        self._line = line
        self._clock = clock
        self._since: dict[int, float] = {}
        """Since when lines wait to be sent."""

    def prepare(
        self, update: CompositorUpdate, size: Size, system: ColorSystem, keyboard: Region, cursor: Offset
    ) -> tuple[PreparedUpdate, list[Region]]:
        """Return what is sent now of an update, and what is left; `keyboard` is the region of the widget that has it."""
        room, brush, left = self._line.room(), self.shown.brush(*size), []
        pieces: Iterable[Piece] = _pieces_of(update)
        urgent = cursor if keyboard.contains_point(cursor) else None
        if room is not None:
            pieces = self._in_order(pieces, keyboard, urgent)
        more = self._line.room(FOR_KEYS) or 0
        try:
            for x, y, strip in pieces:
                if room is None or brush.size < (more if urgent is not None and _has(x, y, strip, urgent) else room):
                    brush.draw(x, y, [(text, _look(style, system)) for text, style, control in strip if not control])
                else:
                    left.append(Region(x, y, strip.cell_length, 1))
        except Exception:
            self.shown.forget()
            raise
        left += [Region(first, y, end - first, 1) for y, first, end in brush.hurt()]
        now = self._clock()
        self._since = {region.y: self._since.get(region.y, now) for region in left}
        return PreparedUpdate(brush.text(), brush.drawn), left

    def _in_order(self, pieces: Iterable[Piece], keyboard: Region, urgent: Offset | None) -> list[Piece]:
        now = self._clock()

        def rank(piece: Piece) -> tuple[bool, float]:
            x, y, strip = piece
            ahead = HEAD_START if keyboard.contains(x, y) else 0.0
            return urgent is None or not _has(x, y, strip, urgent), self._since.get(y, now) - ahead

        return sorted(pieces, key=rank)


def _has(x: int, y: int, strip: Strip, place: Offset) -> bool:
    return y == place.y and x <= place.x < x + strip.cell_length


def _pieces_of(update: CompositorUpdate) -> Iterator[Piece]:
    if isinstance(update, SpansUpdate):
        yield from update.strips
    elif isinstance(update, ChopsUpdate):
        yield from pieces_of_chops(update)
    elif isinstance(update, LayoutUpdate):
        for y, line in enumerate(update.strips, update.region.y):
            x = update.region.x
            for strip in line:
                yield x, y, strip
                x += strip.cell_length


def _look(style: Style | None, system: ColorSystem) -> str:
    if style is None:
        return ""
    look = style._ansi  # where `Strip` keeps it
    return Strip.render_ansi(style, system) if look is None else look
