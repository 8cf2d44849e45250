"""Pictures of burgers that bounce off the edges (image_tools/src/burger.cpp), drawn row by row into bytes."""

from __future__ import annotations

import math
import random

SIDE = 64
"""Pixels of a burger's width and height."""
FEWEST, MOST = 2, 11
FASTEST = 3
"""Pixels from one picture to the next."""
_LAYERS = (
    # first row, last row, half of the width at the first and at the last one, colour (blue, green, red)
    (26, 31, 30, 30, b"\x30\xb0\x40"),
    (32, 35, 29, 29, b"\x30\x30\xd8"),
    (36, 44, 28, 28, b"\x18\x30\x58"),
    (45, 54, 29, 24, b"\x50\xa0\xd8"),
)


def _spans() -> dict[int, tuple[int, bytes]]:
    """Return, by row of a burger, where its pixels begin and what they are."""
    spans: dict[int, tuple[int, bytes]] = {}
    for row in range(8, 26):  # the upper half of the bun
        half = round(30 * math.sqrt(1 - ((25 - row) / 18) ** 2))
        if half:
            spans[row] = (SIDE // 2 - half, b"\x50\xa0\xd8" * (2 * half))
    for first, last, wide, narrow, colour in _LAYERS:
        for row in range(first, last + 1):
            half = round(wide + (narrow - wide) * (row - first) / (last - first))
            spans[row] = (SIDE // 2 - half, colour * (2 * half))
    return spans


class Burgers:
    """Some burgers on black; each call of `draw` moves them on.

    Raises:
        RuntimeError: for a picture smaller than a burger.
    """

    def __init__(self, width: int, height: int) -> None:
        if width < SIDE or height < SIDE:
            raise RuntimeError(f"Target resolution must be at least the burger size ({SIDE} x {SIDE})")
        self._width, self._height = width, height
        self._spans = _spans()
        self._places = [
            [random.randrange(max(width - SIDE, 1)), random.randrange(max(height - SIDE, 1))]
            for _ in range(random.randint(FEWEST, MOST))
        ]
        self._ways = [[random.randint(1, FASTEST), random.randint(1, FASTEST)] for _ in self._places]

    def draw(self) -> bytearray:
        """Return the next picture as rows of pixels of three bytes: blue, green, red."""
        picture = bytearray(3 * self._width * self._height)
        for place, way in zip(self._places, self._ways, strict=True):
            for row, (begin, pixels) in self._spans.items():
                at = 3 * ((place[1] + row) * self._width + place[0] + begin)
                picture[at : at + len(pixels)] = pixels
            for axis, most in enumerate((self._width - SIDE, self._height - SIDE)):
                place[axis] += way[axis]
                if not 0 <= place[axis] <= most:
                    way[axis] = -way[axis]
                    place[axis] = min(max(place[axis], 0), most)
        return picture

    def flipped(self, picture: bytearray) -> bytearray:
        """Return a picture as in a mirror."""
        row = 3 * self._width
        mirrored = bytearray(len(picture))
        for at in range(0, len(picture), row):
            line = picture[at : at + row]
            for colour in range(3):
                mirrored[at + colour : at + row : 3] = line[colour::3][::-1]
        return mirrored
