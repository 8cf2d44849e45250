"""Buttons on a line of a window: the key in a box and what it does beside it, as on the key line; a click is the key."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from rich.segment import Segment

from day6_tui.panes.cells import cell_len, clip
from day6_tui.panes.pane import Action, Pane

TIGHT = 3
"""Cells by which a button is narrower where there is little room."""


LEAST_TEXT = 10
"""Cells that a text keeps when others need room."""


class Button(NamedTuple):
    """What can be clicked, and the key that does the same."""

    key: str
    text: str
    action: Action
    on: bool | None = None
    """Whether its check box is ticked; None for one without a box."""
    mark: str = ""
    """What stands behind the text, however much of that is cut off: that there is a list."""

    @property
    def words(self) -> str:
        box = "" if self.on is None else f"[{'x' if self.on else ' '}] "
        return f"{box}{self.text}{self.mark}"


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


def shortened(buttons: Sequence[Button], width: int, ellipsis: str) -> list[Button]:
    """The buttons for a line of `width` cells; of the first one's text only as much as the others leave room for."""
    first, *others = buttons
    beyond = 1 + sum(cell_width(button) - TIGHT for button in buttons) - width
    if beyond > 0:
        text = clip(first.text, max(LEAST_TEXT, cell_len(first.text) - beyond), ellipsis)
        first = first._replace(text=text)
    return [first, *others]


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
