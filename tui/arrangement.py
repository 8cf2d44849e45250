"""The layout of the panes: a pure function of the desktop's size and of what is open."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

WIDE = 100
"""From this many columns on, terminals and windows are side by side."""

SINGLE_ROWS = 14
"""With fewer rows than this, one pane is shown at a time."""

WINDOW_ROWS = 15
"""A window that would get fewer rows than this is hidden behind another."""


class Place(NamedTuple):
    """A rectangle in cells."""

    x: int
    y: int
    width: int
    height: int


class Arrangement(NamedTuple):
    """The places of the terminal pane and of the visible windows (by number); the other windows are behind them."""

    terminal: Place | None
    windows: dict[int, Place]


def arrange(
    width: int,
    height: int,
    windows: Sequence[int],
    active: int | None,
    *,
    enlarged: str | None = None,
    terminal_focused: bool = True,
    share: float = 0.5,
) -> Arrangement:
    """Lay out a desktop of `width` x `height` cells.

    `windows` are the numbers of the open windows, oldest first, `active` the one used last. `enlarged` is 'terminal',
    'window' (the active one) or None. `share` is the part of the desktop that the windows get.
    """
    whole = Place(0, 0, max(1, width), max(1, height))
    if not windows:
        return Arrangement(whole, {})
    active = active if active in windows else windows[-1]
    assert active is not None
    if enlarged == "window":
        return Arrangement(None, {active: whole})
    if enlarged == "terminal":
        return Arrangement(whole, {})
    if height < SINGLE_ROWS or width < 30:
        return Arrangement(whole, {}) if terminal_focused else Arrangement(None, {active: whole})
    if width < WIDE:
        above = max(5, min(height - 5, round(height * (share + 0.1))))
        return Arrangement(Place(0, above, width, height - above), {active: Place(0, 0, width, above)})
    right = max(30, min(width - 30, round(width * share)))
    left = width - right
    shown = _most_recent(windows, active, max(1, height // WINDOW_ROWS))
    places = {}
    top = 0
    for index, number in enumerate(shown):
        rows = (height - top) // (len(shown) - index)
        places[number] = Place(left, top, right, rows)
        top += rows
    return Arrangement(Place(0, 0, left, height), places)


def _most_recent(windows: Sequence[int], active: int, room: int) -> list[int]:
    """The newest windows and the active one, as many as fit, oldest on top."""
    shown = [number for number in windows if number != active][::-1][: room - 1]
    return sorted([*shown, active], key=list(windows).index)
