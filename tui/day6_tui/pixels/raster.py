"""Drawing without steps: lines, polygons and discs on a surface twice as fine as the picture, which is then made smaller.

Pillow does both; numpy carries the pixels from there.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

FINE = 2
"""Pixels of the surface for one of the picture, across and down."""

Points = Sequence[tuple[float, float]]
Array = NDArray[Any]


def rgb(colour: int) -> tuple[int, int, int]:
    """0xRRGGBB as red, green and blue."""
    return colour >> 16 & 255, colour >> 8 & 255, colour & 255


class Surface:
    """`width` x `height` pixels of one colour; coordinates are pixels from the upper left corner, with fractions."""

    def __init__(self, width: int, height: int, background: int, *, base: Image.Image | None = None) -> None:
        self.width, self.height = width, height
        size = (width * FINE, height * FINE)
        self.image = base.copy() if base is not None else Image.new("RGB", size, rgb(background))
        self._draw = ImageDraw.Draw(self.image)

    def line(self, points: Points, colour: int, width: float = 1.0) -> None:
        """A chain of straight lines."""
        if len(points) > 1:
            fine = [(x * FINE, y * FINE) for x, y in points]
            self._draw.line(fine, fill=rgb(colour), width=max(1, round(width * FINE)), joint="curve")

    def lines(self, chains: Iterable[Points], colour: int, width: float = 1.0) -> None:
        for chain in chains:
            self.line(chain, colour, width)

    def polygon(self, points: Points, colour: int, outline: int | None = None, width: float = 1.0) -> None:
        """A filled polygon."""
        fine = [(x * FINE, y * FINE) for x, y in points]
        if len(fine) > 2:
            self._draw.polygon(fine, fill=rgb(colour))
        if outline is not None and len(fine) > 1:
            self._draw.line([*fine, fine[0]], fill=rgb(outline), width=max(1, round(width * FINE)), joint="curve")

    def disc(self, x: float, y: float, radius: float, colour: int) -> None:
        """A filled circle."""
        x, y, radius = x * FINE, y * FINE, radius * FINE
        self._draw.ellipse((x - radius, y - radius, x + radius, y + radius), fill=rgb(colour))

    def pixels(self) -> Array:
        """The picture: height x width x 3 bytes."""
        return np.asarray(self.image.reduce(FINE))
