"""The path image of turtlesim: 500 x 500 pixels on which turtles draw and from which their colour sensor reads.

Lines are filled as Qt's painter fills them without antialiasing: a pixel belongs to a line when its centre lies inside
the line's rectangle, which reaches half the pen's width beyond both ends (square caps). Pixels count from the top left
corner.
"""

from __future__ import annotations

import math
from collections import deque
from typing import NamedTuple

SIZE = 500
"""Width and height of the image and of the window, in pixels."""

PIXELS_PER_METRE = 45.0
"""turtlesim takes the height of its first turtle picture as one metre."""

UNDRAWN = (255, 255, 255)
"""What the colour sensor reads off the trail: the image is cleared to transparent *white*."""

OUTSIDE = (0, 48, 57)
"""QImage.pixel() answers the number 12345 for a point that is not on the image."""

RECENT = 1024
"""How many of the latest segments are kept for windows that draw along."""

_OPAQUE = 0xFF000000
_FAR = 32767.0  # the raster engine clips coordinates to 16 bits; nothing farther out can reach the image


class Segment(NamedTuple):
    """One drawn line: ends in pixels (y down), colour as 0xRRGGBB, pen width in pixels."""

    x0: float
    y0: float
    x1: float
    y1: float
    rgb: int
    width: int


class Trail:
    """What the turtles have drawn since the last `clear()`.

    One thread draws; others may read at any time. A window that draws along keeps the `generation` and the `drawn` it
    has seen: another generation means the image was wiped, `segments_since()` gives what came since, or None if the
    window was away for too long and has to rebuild from `pixels` (row by row: 0 where nothing is, else 0xFFRRGGBB).
    """

    def __init__(self) -> None:
        self.generation = 0
        self.drawn = 0
        self.inks: set[int] = set()
        """The colours of all lines since then, as 0xRRGGBB."""
        self.jumps: deque[tuple[int, int]] = deque(maxlen=RECENT)
        """The latest teleports: the numbers of the next segment before and after each, two alike where it drew nothing."""
        self._recent: list[tuple[int, Segment] | None] = [None] * RECENT
        self.pixels = _blank()

    def clear(self) -> None:
        """Wipe everything (the services clear and reset)."""
        # A new buffer instead of wiping the old one: a reader on another thread keeps a whole picture.
        self.pixels = _blank()
        self._recent = [None] * RECENT
        self.drawn = 0
        self.inks = set()
        self.jumps = deque(maxlen=RECENT)
        self.generation += 1

    def colour_at(self, x: float, y: float) -> tuple[int, int, int]:
        """Return red, green, blue (0..255) of the pixel nearest to the point (x, y), in pixels."""
        if not (0.0 <= x < SIZE - 0.5 and 0.0 <= y < SIZE - 0.5):
            return OUTSIDE
        value = self.pixels[int(y + 0.5) * SIZE + int(x + 0.5)]
        if not value:
            return UNDRAWN
        return value >> 16 & 255, value >> 8 & 255, value & 255

    def draw_line(self, x0: float, y0: float, x1: float, y1: float, rgb: int, width: int) -> None:
        """Draw from (x0, y0) to (x1, y1), in pixels; infinite or undefined ends draw nothing."""
        if not (abs(x0) <= _FAR and abs(y0) <= _FAR and abs(x1) <= _FAR and abs(y1) <= _FAR):
            return
        self.inks.add(rgb)
        (self._fill if width > 1 else self._trace)(x0, y0, x1, y1, rgb | _OPAQUE, width)
        number = self.drawn
        self._recent[number % RECENT] = number, Segment(x0, y0, x1, y1, rgb, width)
        self.drawn = number + 1

    def segments_since(self, seen: int) -> list[Segment] | None:
        """Return the segments numbered `seen` and later, or None if some of them are no longer kept."""
        recent, end = self._recent, self.drawn
        if seen < 0 or seen > end or end - seen > RECENT:
            return None
        found = []
        for number in range(seen, end):
            entry = recent[number % RECENT]
            if entry is None or entry[0] != number:
                return None
            found.append(entry[1])
        return found

    def _fill(self, x0: float, y0: float, x1: float, y1: float, value: int, width: int) -> None:
        dx, dy = x1 - x0, y1 - y0
        length = math.hypot(dx, dy)
        half = width / 2
        ux, uy = (dx / length, dy / length) if length else (1.0, 0.0)
        middle_x, middle_y = (x0 + x1) / 2, (y0 + y1) / 2
        along = length / 2 + half
        reach = along * abs(uy) + half * abs(ux)
        # A centre exactly on the left or upper edge is outside, on the right or lower edge inside, as in Qt.
        top = max(0, math.floor(middle_y - reach - 0.5) + 1)
        bottom = min(SIZE - 1, math.floor(middle_y + reach - 0.5))
        pixels = self.pixels
        for row in range(top, bottom + 1):
            q = row + 0.5 - middle_y
            # The rectangle is where two strips cross: between its short sides, and between its long sides.
            left, right = -_FAR, _FAR
            if abs(ux) > 1e-9:
                a, b = (-along - uy * q) / ux, (along - uy * q) / ux
                left, right = (a, b) if a < b else (b, a)
            if abs(uy) > 1e-9:
                a, b = (ux * q - half) / uy, (ux * q + half) / uy
                if a > b:
                    a, b = b, a
                left, right = (a if a > left else left), (b if b < right else right)
            first = max(0, math.floor(middle_x + left - 0.5) + 1)
            last = min(SIZE - 1, math.floor(middle_x + right - 0.5))
            for index in range(row * SIZE + first, row * SIZE + last + 1):
                pixels[index] = value

    def _trace(self, x0: float, y0: float, x1: float, y1: float, value: int, _: int) -> None:
        """Draw a line one pixel wide: in each column (or row, of a steep line) the pixel that its middle passes."""
        dx, dy = x1 - x0, y1 - y0
        if not (dx or dy):
            self._set(math.floor(x0 + 0.5), math.floor(y0 + 0.5), value)
        elif abs(dx) > abs(dy):
            slope = dy / dx
            for column in range(max(0, math.floor(min(x0, x1))), min(SIZE - 1, math.floor(max(x0, x1))) + 1):
                self._set(column, math.floor(y0 + (column + 0.5 - x0) * slope), value)
        else:
            slope = dx / dy
            for row in range(max(0, math.floor(min(y0, y1))), min(SIZE - 1, math.floor(max(y0, y1))) + 1):
                self._set(math.floor(x0 + (row + 0.5 - y0) * slope), row, value)

    def _set(self, column: int, row: int, value: int) -> None:
        if 0 <= column < SIZE and 0 <= row < SIZE:
            self.pixels[row * SIZE + column] = value


def _blank() -> memoryview[int]:
    # bytearray(n) is cleared by the system page by page on first use, so an empty image costs no memory.
    return memoryview(bytearray(SIZE * SIZE * 4)).cast("I")
