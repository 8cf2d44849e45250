"""The picture of a turtle from above, at any size and heading: as pixels, or as characters where there are no pixels."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

HEADINGS = 32
"""Directions in which a turtle is drawn: finer steps are indistinguishable at these sizes, and would redraw it needlessly."""

REAL_SIZE = 45.0 / 500.0
"""A turtle's picture is 45 pixels of the world's 500 (turtlesim/turtle_frame.cpp)."""

SMALLEST = 7
"""Pixels across a drawn turtle below which head and legs do not show any more."""


class Coat(NamedTuple):
    """Colours 0xRRGGBB of one turtle."""

    shell: int
    pattern: int
    legs: int
    head: int


COATS = (
    Coat(0x2E9E5B, 0x176B3A, 0x8FBF6A, 0xE2F7B5),
    Coat(0xE69F00, 0x9C6500, 0xD9B878, 0xFFF1CC),
    Coat(0xD55E96, 0x8E2F60, 0xDD9CBD, 0xFFE3EF),
    Coat(0xF0E442, 0xA89A00, 0xC9C27A, 0xFFFFE0),
    Coat(0x35B6C9, 0x14707E, 0x86BFC7, 0xE4FCFF),
    Coat(0xE8E8E8, 0x8C8C8C, 0xB8B8B8, 0xFFFFFF),
    Coat(0x8C5A2B, 0x5A3413, 0xB28F66, 0xF4DFC2),
    Coat(0x303030, 0x000000, 0x707070, 0xD8D8D8),
)
"""One after the other for the turtles of a window; they differ in lightness as well as in hue."""


FLAGS = (0x008000, 0x800000, 0x800080, 0x808000, 0x008080, 0x808080, 0x000080, 0x000000)
"""For each coat one of the sixteen colours every terminal has."""


def heading_step(theta: float) -> int:
    """The drawn direction (0 = along +x, counter-clockwise) for an angle in radians."""
    if not math.isfinite(theta):
        return 0
    return round(theta / (2 * math.pi) * HEADINGS) % HEADINGS


@lru_cache(maxsize=512)
def pixels(size: int, step: int) -> tuple[tuple[int, int, int], ...]:
    """A turtle `size` pixels across: (dx, dy, part) with part an index into `Coat`; dy counts down."""
    angle = 2 * math.pi * step / HEADINGS
    if size < SMALLEST:
        return _tiny(angle)
    cos, sin = math.cos(angle), math.sin(angle)
    radius = size / 2
    reach = math.ceil(radius)
    found = []
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            # Into the turtle's own frame: u ahead, v to its left, in units of its radius.
            u, v = (dx * cos - dy * sin) / radius, (-dx * sin - dy * cos) / radius
            part = _part(u, v)
            if part is not None:
                found.append((dx, dy, part))
    return tuple(found)


def _part(u: float, v: float) -> int | None:
    if ((u + 0.10) / 0.66) ** 2 + (v / 0.60) ** 2 <= 1:
        return 1 if ((u + 0.10) / 0.36) ** 2 + (v / 0.30) ** 2 <= 1 else 0
    if ((u - 0.74) / 0.32) ** 2 + (v / 0.28) ** 2 <= 1:
        return 3
    if (abs(u + 0.08) - 0.50) ** 2 + (abs(v) - 0.64) ** 2 <= 0.24**2:
        return 2
    if -1.0 <= u < -0.6 and abs(v) <= 0.12:
        return 2
    return None


def _tiny(angle: float) -> tuple[tuple[int, int, int], ...]:
    """Three by three pixels and a head: the smallest thing that has a front."""
    near = (round(1.1 * math.cos(angle)), -round(1.1 * math.sin(angle)))
    body = [(dx, dy, 3 if (dx, dy) == near else 0) for dx in (-1, 0, 1) for dy in (-1, 0, 1) if (dx, dy) != (0, 0)]
    return (*body, (0, 0, 1), (round(2 * math.cos(angle)), -round(2 * math.sin(angle)), 3))


_NECKS = ("-", "/", "|", "\\", "-", "/", "|", "\\")
_NECK_PLACES = ((1, 0), (1, -1), (0, -1), (-1, -1), (-1, 0), (-1, 1), (0, 1), (1, 1))


def characters(step: int, body: str) -> tuple[tuple[int, int, str], ...]:
    """A turtle of two characters, for terminals without pixels: (column, row, character) from its place."""
    eighth = round(step / (HEADINGS / 8)) % 8
    dx, dy = _NECK_PLACES[eighth]
    return (0, 0, body), (dx, dy, _NECKS[eighth])
