"""TurtleSim's world as a bitmap: the trail at the window's resolution, and turtles with shell, head and feet."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from PIL import Image, ImageDraw
from rich.style import Style

from day6_core.ros.programs.turtlesim.model import HEIGHT, SIZE, WIDTH, Trail, TurtleScene
from day6_tui.appearance.colours import background_of, contrasting, pixel_style
from day6_tui.panes.cells import cell_len
from day6_tui.pixels.bands import Array
from day6_tui.pixels.raster import rgb
from day6_tui.pixels.sheet import Sheet
from day6_tui.windows.turtlesim.shapes import REAL_SIZE, Coat

HEADINGS = 120
"""Directions in which a turtle is drawn: three degrees."""

SMALLEST = 16
"""Pixels across a turtle, in a world however small."""

MARGIN = 6
"""Pixels around a new piece of the trail that are made anew with it."""

FINE = 4
"""Pixels drawn for one of a turtle, across and down."""

REACH = 1.2
"""A turtle's feet reach beyond its radius by this factor."""


class TurtlePicture:
    """`columns` x `rows` cells of `cell` pixels, with the world as a square in their middle."""

    def __init__(self, columns: int, rows: int, cell: tuple[int, int], blank: Style) -> None:
        self.columns, self.rows, self.cell = columns, rows, cell
        self.sheet = Sheet(columns, rows, blank)
        self._around = rgb(max(0, background_of(blank)))
        width, height = columns * cell[0], rows * cell[1]
        self._side = min(width, height)
        self._corner = (width - self._side) // 2, (height - self._side) // 2
        self._ground = Image.new("RGB", (width, height), self._around)
        self._background: tuple[int, int, int] | None = None
        self._generation = self._drawn = -1

    def pixels(self, scene: TurtleScene, trail: Trail, coats: dict[str, Coat]) -> Array:
        """The world now: height x width x 3 bytes."""
        self._take_trail(scene.background, trail)
        picture = self._ground.copy()
        size = max(SMALLEST, round(self._side * REAL_SIZE))
        for turtle in scene.turtles:
            x, y = self._place(turtle.x, turtle.y)
            turtle_image = _turtle(size, _heading(turtle.theta), coats[turtle.name])
            left, top = x - turtle_image.width // 2, y - turtle_image.height // 2
            picture.paste(turtle_image, (left, top), turtle_image)
        return np.asarray(picture)

    def names(self, scene: TurtleScene) -> list[tuple[int, int, str, Style]]:
        """The turtles' names, above them, for the sheet."""
        red, green, blue = scene.background
        ground = red << 16 | green << 8 | blue
        style = pixel_style(contrasting(ground), ground)
        size = max(SMALLEST, round(self._side * REAL_SIZE))
        found = []
        for turtle in scene.turtles:
            x, y = self._place(turtle.x, turtle.y)
            width = cell_len(turtle.name)
            column = max(0, min(self.columns - width, x // self.cell[0] - width // 2))
            above, below = (y - size // 2) // self.cell[1] - 1, (y + size // 2) // self.cell[1] + 1
            found.append((column, above if above >= 0 else min(self.rows - 1, below), turtle.name, style))
        return found

    def _place(self, x: float, y: float) -> tuple[int, int]:
        """The pixel of a place in the world; undefined numbers lie in the lower left corner."""
        across, up = (value if math.isfinite(value) else 0.0 for value in (x / WIDTH, y / HEIGHT))
        part, last = self._side, self._side - 1
        return (
            self._corner[0] + round(max(0.0, min(1.0, across)) * last),
            self._corner[1] + round((1 - max(0.0, min(1.0, up))) * last) % part,
        )

    def _take_trail(self, background: tuple[int, int, int], trail: Trail) -> None:
        generation, drawn, image = trail.generation, trail.drawn, trail.pixels
        known = generation == self._generation and background == self._background
        strokes = trail.segments_since(self._drawn) if known else None
        self._generation, self._drawn, self._background = generation, drawn, background
        part = self._side / SIZE
        if strokes is None:
            self._renew(image, background, (0, 0, self._side, self._side))
            return
        for stroke in strokes:
            reach = stroke.width * part + MARGIN
            ends = (stroke.x0 * part, stroke.x1 * part), (stroke.y0 * part, stroke.y1 * part)
            (left, right), (top, bottom) = ((int(min(pair) - reach), int(max(pair) + reach) + 1) for pair in ends)
            box = max(0, left), max(0, top), min(self._side, right), min(self._side, bottom)
            if box[0] < box[2] and box[1] < box[3]:
                self._renew(image, background, box)

    def _renew(self, image: memoryview, background: tuple[int, int, int], box: tuple[int, int, int, int]) -> None:
        """Make a rectangle of the world from the program's image of `SIZE` x `SIZE` pixels (0xAARRGGBB, 0 undrawn)."""
        part = SIZE / self._side
        left, top, right, bottom = box
        x0, y0 = max(0, int(left * part) - MARGIN), max(0, int(top * part) - MARGIN)
        x1, y1 = min(SIZE, math.ceil(right * part) + MARGIN), min(SIZE, math.ceil(bottom * part) + MARGIN)
        ink = np.frombuffer(image, np.uint32).reshape(SIZE, SIZE)[y0:y1, x0:x1]
        colours = np.stack([ink >> 16 & 255, ink >> 8 & 255, ink & 255], axis=-1).astype(np.uint8)
        colours[ink == 0] = background
        source = (left * part - x0, top * part - y0, right * part - x0, bottom * part - y0)
        made = Image.fromarray(colours).resize((right - left, bottom - top), Image.Resampling.BILINEAR, box=source)
        self._ground.paste(made, (self._corner[0] + left, self._corner[1] + top))


def _heading(theta: float) -> int:
    return round(theta / (2 * math.pi) * HEADINGS) % HEADINGS if math.isfinite(theta) else 0


def _oval(u: float, v: float, along: float, across: float, turn: float = 0.0) -> list[tuple[float, float]]:
    """An ellipse around (u ahead, v to the left), turned by an angle."""
    cos, sin = math.cos(turn), math.sin(turn)
    angles = [2 * math.pi * i / 28 for i in range(28)]
    points = [(along * math.cos(angle), across * math.sin(angle)) for angle in angles]
    return [(u + x * cos - y * sin, v + x * sin + y * cos) for x, y in points]


def _parts() -> list[tuple[int, list[tuple[float, float]]]]:
    """Outlines in units of the turtle's radius: (part of the coat, or -1 for the eyes; points)."""
    feet = [
        _oval(u, side * 0.62, 0.30, 0.17, side * turn) for u, turn in ((0.46, 0.9), (-0.56, -0.9)) for side in (1, -1)
    ]
    plates = [_oval(-0.10 + u, v, 0.17, 0.15) for u, v in ((0.30, 0.0), (0.0, 0.28), (0.0, -0.28), (-0.30, 0.0))]
    return [
        *((2, foot) for foot in feet),
        (2, [(-0.60, 0.13), (-1.0, 0.0), (-0.60, -0.13)]),
        (3, _oval(0.72, 0.0, 0.28, 0.23)),
        *((-1, _oval(0.82, side * 0.13, 0.05, 0.05)) for side in (1, -1)),
        (1, _oval(-0.10, 0.0, 0.68, 0.60)),
        (0, _oval(-0.10, 0.0, 0.60, 0.52)),
        (1, _oval(-0.10, 0.0, 0.13, 0.13)),
        *((1, plate) for plate in plates),
    ]


_PARTS: Sequence[tuple[int, list[tuple[float, float]]]] = tuple(_parts())


@lru_cache(maxsize=256)
def _turtle(size: int, heading: int, coat: Coat) -> Image.Image:
    """A turtle of `size` pixels from head to tail, with transparent surroundings."""
    side = math.ceil(size * REACH) * FINE
    image = Image.new("RGBA", (side, side), (0, 0, 0, 0))
    draw = ImageDraw.Draw(image)
    angle, radius, middle = 2 * math.pi * heading / HEADINGS, size * FINE / 2, side / 2
    cos, sin = math.cos(angle), math.sin(angle)
    for part, points in _PARTS:
        colour = rgb(coat[part]) if part >= 0 else (20, 20, 20)
        spots = [(middle + radius * (u * cos - v * sin), middle - radius * (u * sin + v * cos)) for u, v in points]
        draw.polygon(spots, fill=(*colour, 255))
    return image.reduce(FINE)
