"""The names of the panes of one place, as tabs on its upper edge."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import NamedTuple

from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip
from day6_tui.panes.pane import Piece

TAB_WIDTH = 24
"""Cells the name of one of several tabs may take."""

NAME_SHOWN = 12
"""With fewer cells for each, only the one in front keeps its name: of the others a word of it is shown."""

WORD_SHOWN = 5
"""Cells of that word where room is short. With fewer it says nothing: rather there are fewer tabs."""

FILLING = {"", "day6", "gui", "key", "launch", "node", "publisher", "py", "ros2", "rqt"}
"""Words that are in so many names that they tell nothing."""


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
    """The names, as long as they fit side by side, or shorter ones, as far as they still tell something."""
    news = [f" {look.glyphs.news}" if tab.news else "" for tab in tabs]
    names = [tab.label for tab in tabs]
    if len(names) == 1:
        return [clip(names[0], max(1, room - 2 - len(news[0])), look.glyphs.ellipsis) + news[0]]
    room -= 2 * len(names) + sum(map(len, news))
    found = _names_that_fit(tabs, front, room, look.glyphs.ellipsis)
    return [name + new for name, new in zip(found, news, strict=True)]


def _names_that_fit(tabs: Sequence[Tab], front: int, room: int, ellipsis: str) -> list[str]:
    names = [tab.label for tab in tabs]
    lengths = [cell_len(name) for name in names]
    for width in range(TAB_WIDTH, NAME_SHOWN - 1, -1):
        if sum(min(width, length) for length in lengths) <= room:
            return [clip(name, width, ellipsis) for name in names]
    words = [tab._replace(name=word).label for tab, word in zip(tabs, _words([tab.name for tab in tabs]), strict=True)]
    stubs = [clip(word, len(tab.number) + 1 + WORD_SHOWN, ellipsis) for tab, word in zip(tabs, words, strict=True)]
    for others in (words, stubs):
        rest = room - sum(map(cell_len, others)) + cell_len(others[front])
        if rest >= min(NAME_SHOWN, lengths[front]):
            break
    others[front] = clip(names[front], max(NAME_SHOWN, min(TAB_WIDTH, rest)), ellipsis)
    return others


def _words(names: Sequence[str]) -> list[str]:
    """The first word of each name that tells something; the last one where other names begin with the same."""
    words = [[word for word in re.split(r"[\W_]+", name) if word not in FILLING] or [name] for name in names]
    firsts = [each[0] for each in words]
    return [each[-1] if firsts.count(each[0]) > 1 else each[0] for each in words]


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
