"""Buttons on a line of a window: the key in a box and what it does beside it, as on the key line; a click is the key."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from rich.segment import Segment

from day6_tui.tui.cells import cell_len, clip
from day6_tui.tui.pane import Action, Pane

TIGHT = 3
"""Cells by which a button is narrower where there is little room."""


class Button(NamedTuple):
    """What can be clicked, and the key that does the same."""

    key: str
    text: str
    action: Action
    on: bool | None = None
    """Whether its check box is ticked; None for one without a box."""

    @property
    def words(self) -> str:
        return self.text if self.on is None else f"[{'x' if self.on else ' '}] {self.text}"


def button_line(pane: Pane, y: int, pieces: Sequence[Segment | Button], width: int) -> list[Segment]:
    """Texts and buttons on line `y` of the inside of a pane, with what can be clicked; what has no room is cut off."""
    roomy = sum(map(cell_width, pieces)) <= width
    box, gap = (" {} ", "  ") if roomy else ("{}", " ")
    colours, ellipsis = pane.look.colours, pane.look.glyphs.ellipsis
    segments = [Segment(" ", pane.background)]
    x = 1
    for piece in pieces:
        if isinstance(piece, Button):
            key = box.format(piece.key)
            words = clip(f" {piece.words}", max(0, width - x - cell_len(key)), ellipsis)
            end = x + cell_len(key) + cell_len(words)
            if end > width:
                break
            pane.add_hit(y + pane.inner_offset, x + pane.inner_offset, end + pane.inner_offset, piece.action)
            style = colours.muted if piece.on is False else colours.text
            segments += [Segment(key, colours.key), Segment(words, style), Segment(gap, pane.background)]
            x = end + len(gap)
        else:
            segments.append(piece)
            x += piece.cell_length
    return segments


def cell_width(piece: Segment | Button) -> int:
    """Cells that a piece has where there is room, with the gap behind it."""
    return len(piece.key) + cell_len(piece.words) + 5 if isinstance(piece, Button) else piece.cell_length


def beyond_of(buttons: Sequence[Button], width: int) -> int:
    """How many cells too many buttons have, however narrowly they are drawn; at most 0 if there is room."""
    return sum(cell_width(button) - TIGHT for button in buttons) + 1 - width


def in_lines(buttons: Iterable[Button], width: int) -> list[list[Button]]:
    """The buttons in as many lines of at most `width` cells as they need."""
    lines: list[list[Button]] = [[]]
    room = width
    for button in buttons:
        size = cell_width(button)
        if room < size and lines[-1]:
            lines.append([])
            room = width
        lines[-1].append(button)
        room -= size
    return lines
