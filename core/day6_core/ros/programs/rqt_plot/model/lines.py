"""Straight lines on a grid of pixels."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise


def line(x0: int, y0: int, x1: int, y1: int) -> Iterator[tuple[int, int]]:
    """Yield the pixels between two, both included (Bresenham)."""
    dx, dy = abs(x1 - x0), -abs(y1 - y0)
    step_x, step_y = (1 if x1 > x0 else -1), (1 if y1 > y0 else -1)
    error = dx + dy
    while True:
        yield x0, y0
        if (x0, y0) == (x1, y1):
            return
        twice = 2 * error
        if twice >= dy:
            error += dy
            x0 += step_x
        if twice <= dx:
            error += dx
            y0 += step_y


def polyline(points: Sequence[tuple[int, int]], width: int, height: int) -> set[tuple[int, int]]:
    """Return the pixels of a curve through points, those outside of the picture left out.

    Points of one column are drawn as the upright line between the lowest and the highest: a second may have thousands.
    """
    found: set[tuple[int, int]] = set()
    reduced: list[tuple[int, int]] = []
    column: list[tuple[int, int]] = []
    for point in [*points, (-1, 0)]:
        if column and point[0] != column[0][0]:
            heights = [y for _, y in column]
            found.update((column[0][0], y) for y in range(min(heights), max(heights) + 1))
            reduced += [column[0], column[-1]]
            column = []
        column.append(point)
    for (x0, y0), (x1, y1) in pairwise(reduced):
        found.update(line(x0, y0, x1, y1))
    return {(x, y) for x, y in found if 0 <= x < width and 0 <= y < height}
