"""What a picture file of a graph is drawn with. Coordinates are pixels, y down; every kind of file draws the same strokes."""

from __future__ import annotations

from typing import NamedTuple

Point = tuple[float, float]

FONT_SIZE = 14
INK = "#000000"


class Ellipse(NamedTuple):
    """Corners of what it fills."""

    corner: Point
    opposite: Point
    colour: str


class InkLine(NamedTuple):
    """Straight pieces through all points."""

    points: tuple[Point, ...]
    colour: str


class Arrow(NamedTuple):
    """A filled triangle."""

    points: tuple[Point, Point, Point]


class InkText(NamedTuple):
    """A text around its middle, or from its left end."""

    at: Point
    text: str
    colour: str
    centred: bool


Stroke = Ellipse | InkLine | Arrow | InkText
