"""Where texts stand in a picture of cells: at their points, or close by where another text is in the way."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from day6_tui.tui.cells import cell_len

ROWS = (0, 1, -1, 2, -2, 3, -3)
"""How far a text may be moved down or up, in the order in which that is tried."""


class Place(NamedTuple):
    """The first cell of a text."""

    column: int
    row: int


def label_places(texts: Sequence[tuple[float, float, str]], columns: int, rows: int) -> list[Place | None]:
    """Places of texts that shall stand above the cells (x, y); None for one that there is no room for.

    The earlier text has the better place. A text is centred, or as near to that as the edges allow. Of all rows close by the
    nearest in which it touches no other is taken; if there is none, it stands to the right of its point, or to the left.
    """
    taken: dict[int, list[tuple[int, int]]] = {}
    places: list[Place | None] = []
    for x, y, text in texts:
        width = cell_len(text)
        place = _place(int(x), int(y), width, columns, rows, taken) if 0 < width <= columns else None
        if place is not None:
            taken.setdefault(place.row, []).append((place.column, place.column + width))
        places.append(place)
    return places


def _place(
    x: int, y: int, width: int, columns: int, rows: int, taken: dict[int, list[tuple[int, int]]]
) -> Place | None:
    for first in (x - width // 2, x + 2, x - width - 1):
        column = max(0, min(first, columns - width))
        for step in ROWS:
            others = taken.get(y + step, ())
            if 0 <= y + step < rows and all(column > end or left > column + width for left, end in others):
                return Place(column, y + step)
    return None
