"""The Displays panel as a drawer: whether it is open, and how panel, edge and view share the window."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from textual.geometry import Region

NARROW = 72
"""Below so many columns the picture comes first: the panel folds away as soon as there is something to see."""

NARROWEST_PANEL, WIDEST_PANEL, NARROWEST_VIEW = 30, 48, 20
"""Columns of both beside each other."""

LOWEST_PANEL, LOWEST_VIEW = 5, 5
"""Rows of both, one above the other: where they would be too narrow beside each other."""

EDGE = 1
"""Columns, or rows, of the edge between panel and view. A click on it folds the panel, as on the arrow at RViz's docks."""


class Division(NamedTuple):
    """Where the parts of the window are, in cells from the upper left one of their common place."""

    panel: Region
    """Empty while it is folded away."""
    edge: Region
    view: Region


NOTHING = Division(Region(), Region(), Region())
"""A window that has no room yet."""


@lru_cache(maxsize=16)
def divide(width: int, height: int, *, panel_open: bool) -> Division:
    """Divide `width` x `height` cells: beside each other, or one above the other, and never without a view."""
    width, height = max(0, width), max(0, height)
    if not panel_open:
        return _beside(0, width, height)
    if width >= NARROWEST_PANEL + EDGE + NARROWEST_VIEW:
        return _beside(max(NARROWEST_PANEL, min(WIDEST_PANEL, width * 3 // 8)), width, height)
    if height >= LOWEST_PANEL + EDGE + LOWEST_VIEW:
        rows = (height - EDGE) // 2
        below = rows + EDGE
        return Division(
            Region(0, 0, width, rows), Region(0, rows, width, EDGE), Region(0, below, width, height - below)
        )
    return _beside(width * 3 // 5, width, height)


def _beside(panel: int, width: int, height: int) -> Division:
    left = min(width, panel + EDGE)
    return Division(
        Region(0, 0, panel, height), Region(panel, 0, left - panel, height), Region(left, 0, width - left, height)
    )


class Drawer:
    """Whether the panel is open: as the person wants it, and before a person has said so, as suits what there is to see.

    Wide windows and narrow ones are remembered apart.
    """

    def __init__(self, *, empty: bool) -> None:
        self.empty = empty
        """Whether there has been nothing to see so far, so that the first thing to do is in the tree."""
        self._wanted: dict[bool, bool] = {}

    def is_open(self, width: int) -> bool:
        """Whether it is open in a window of this width."""
        return self._wanted.get(width < NARROW, width >= NARROW or self.empty)

    def want(self, width: int, *, on: bool) -> None:
        """The person opens or folds it."""
        self._wanted[width < NARROW] = on
