"""How the RViz window is divided between the Displays panel, the edge beside it, and the view."""

from __future__ import annotations

from typing import NamedTuple

NARROW = 72
"""Below so many columns the panel folds away when the view is used, so that the picture has the window to itself."""

NARROWEST_PANEL, WIDEST_PANEL, NARROWEST_VIEW = 30, 48, 20

EDGE = 1
"""Columns of the edge between panel and view. A click on it folds the panel, as on the arrow at the edge of RViz's docks."""


class Division(NamedTuple):
    """Columns of the panel (0 while it is folded), the first column of the view, and its columns (0 if it has no room)."""

    panel: int
    view_left: int
    view: int


def divide(width: int, *, panel_open: bool) -> Division:
    """Divide a window of `width` columns: three eighths for the panel, all of it where the view would be too narrow."""
    panel = max(NARROWEST_PANEL, min(WIDEST_PANEL, width * 3 // 8)) if panel_open else 0
    if panel and width - panel - EDGE < NARROWEST_VIEW:
        panel = max(0, width - EDGE)
    left = panel + EDGE
    return Division(panel, left, max(0, width - left))
