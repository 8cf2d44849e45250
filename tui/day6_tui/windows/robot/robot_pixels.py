"""The painter of robots on a surface of real pixels."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from day6_tui.pixels.raster import Surface

Spot = tuple[float, float]

EDGE = 1.5
"""Pixels across an outline."""


class SurfacePainter:
    """A `topview.paint.Painter`; `place` turns metres of the root frame into pixels, `scale` of them a metre."""

    def __init__(self, surface: Surface, place: Callable[[Spot], Spot], scale: float) -> None:
        self._surface, self._place, self._scale = surface, place, scale

    def polygon(self, points: Sequence[Spot], fill: int, edge: int = -1) -> None:
        self._surface.polygon([self._place(spot) for spot in points], fill, None if edge < 0 else edge, EDGE)

    def disc(self, spot: Spot, radius: float, fill: int, edge: int = -1) -> None:
        x, y = self._place(spot)
        size = max(2.0, radius * self._scale)
        if edge >= 0:
            self._surface.disc(x, y, size, edge)
            size -= EDGE
        self._surface.disc(x, y, size, fill)
