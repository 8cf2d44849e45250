"""rqt_plot's curves as fine lines over a faint grid."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from day6_tui.pixels.bands import Array
from day6_tui.pixels.raster import Points, Surface

CURVE_WIDTH = 1.6
GRID_WIDTH = 0.5


def paint_plot(
    size: tuple[int, int],
    background: int,
    grid: tuple[int, Sequence[float], Sequence[float]],
    curves: Iterable[tuple[int, Points]],
) -> Array:
    """A picture of `size` pixels; `grid` is a colour with the columns and rows of its lines, each curve a colour with pixels."""
    width, height = size
    surface = Surface(width, height, background)
    colour, columns, rows = grid
    surface.lines(([(x, 0), (x, height)] for x in columns), colour, GRID_WIDTH)
    surface.lines(([(0, y), (width, y)] for y in rows), colour, GRID_WIDTH)
    for colour, points in curves:
        if len(points) == 1:
            surface.disc(*points[0], CURVE_WIDTH, colour)
        surface.line(points, colour, CURVE_WIDTH)
    return surface.pixels()
