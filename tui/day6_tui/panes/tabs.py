"""The names of the panes of one place, as tabs on its upper edge."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip
from day6_tui.panes.pane import Piece

TAB_WIDTH = 24
"""Cells the name of one of several tabs may take."""

SHORTEST_NAME = 6
"""With fewer cells a tab's name says nothing: only its number is shown."""


class Tab(NamedTuple):
    """A pane's name and what a click on it does. `number` is '' where panes have none."""

    number: str
    name: str
    news: bool
    choose: Callable[[], object]

    @property
    def label(self) -> str:
        return f"{self.number} {self.name}".strip()


def tab_pieces(
    look: Look, tabs: Sequence[Tab], front: int, *, focused: bool, room: int, list_all: Callable[[], object]
) -> list[Piece]:
    """The tabs that fit into `room` cells, the one at `front` always; a click on `+3` lists those that do not fit."""
    labels = _labels(look, tabs, front, room)
    first, end = _that_fit([cell_len(label) + 2 for label in labels], front, room)
    missing = len(labels) - (end - first)
    if missing:
        more = f" +{missing} "
        first, end = _that_fit([cell_len(label) + 2 for label in labels], front, room - len(more))
        more = f" +{len(labels) - (end - first)} "
    pieces = []
    colours = look.colours
    for index in range(first, end):
        style = colours.title
        if index == front:
            style = colours.title_focus if focused else colours.strong if len(tabs) > 1 else colours.title
        pieces.append(
            Piece(f" {clip(labels[index], max(1, room - 2), look.glyphs.ellipsis)} ", style, tabs[index].choose)
        )
    if missing:
        pieces.append(Piece(more, colours.title, list_all))
    return pieces


def _labels(look: Look, tabs: Sequence[Tab], front: int, room: int) -> list[str]:
    """As much of the names as fits side by side, at least the numbers, and the name of the one in front as far as possible."""
    news = [f" {look.glyphs.news}" if tab.news else "" for tab in tabs]
    names = [tab.label for tab in tabs]
    if len(names) == 1:
        return [clip(names[0], max(1, room - 2 - len(news[0])), look.glyphs.ellipsis) + news[0]]
    room -= 2 * len(names) + sum(map(len, news))
    width = TAB_WIDTH
    while width > 2 and sum(min(width, cell_len(name)) for name in names) > room:
        width -= 1
    if width < SHORTEST_NAME and all(tab.number for tab in tabs):
        numbers = [tab.number for tab in tabs]
        rest = room - sum(map(len, numbers)) + len(numbers[front])
        numbers[front] = clip(names[front], rest, look.glyphs.ellipsis) if rest >= SHORTEST_NAME else numbers[front]
        names, width = numbers, max(map(cell_len, numbers))
    return [clip(name, max(width, 2), look.glyphs.ellipsis) + new for name, new in zip(names, news, strict=True)]


def _that_fit(widths: Sequence[int], front: int, room: int) -> tuple[int, int]:
    """The first tab that is shown and the one after the last: the one in front and as many beside it as fit."""
    room -= widths[front]
    first, end = front, front + 1
    while True:
        before = widths[first - 1] if first > 0 else 0
        after = widths[end] if end < len(widths) else 0
        if before and before <= room and (not after or front - first <= end - front):
            first, room = first - 1, room - before
        elif after and after <= room:
            end, room = end + 1, room - after
        elif before and before <= room:
            first, room = first - 1, room - before
        else:
            return first, end
