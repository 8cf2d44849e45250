"""A picture of real pixels as half blocks, for who sees the screen as text only: a teacher who watches."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from rich.color import Color
from rich.segment import Segment
from rich.style import Style
from textual.geometry import Region
from textual.strip import Strip

from day6_tui.tui.pixels.bands import Array


def over(strips: Sequence[Strip], corner: tuple[int, int], visible: Iterable[Region], halves: Array) -> list[Strip]:
    """Return the lines of a screen with the visible parts of a picture on them.

    `corner` is the column and line of the picture, `halves` what `halved` has made of it.
    """
    drawn, (x, y) = list(strips), corner
    for part in visible:
        for line in range(part.y, min(part.bottom, len(drawn))):
            top, bottom = halves[2 * (line - y)], halves[2 * (line - y) + 1]
            cells = [_cell(top[column - x], bottom[column - x]) for column in range(part.x, part.right)]
            strip = drawn[line]
            drawn[line] = Strip.join([strip.crop(0, part.x), Strip(cells), strip.crop(part.right)]).simplify()
    return drawn


def halved(pixels: Array, cell: tuple[int, int]) -> Array:
    """Return a colour for the upper and the lower half of each cell: 2 x rows, columns, 3.

    Between the mean and what differs most from the picture's ground, so that a thin line is still seen.
    """
    across, down = cell
    rows, columns = len(pixels) // down, pixels.shape[1] // across
    blocks = pixels[: rows * down, : columns * across].astype(np.int32).reshape(rows, down, columns, across, 3)
    ground = _most_frequent(pixels)
    made = np.empty((2 * rows, columns, 3), np.uint8)
    split = max(1, down // 2)
    for half, lines in enumerate((slice(0, split), slice(split if down > 1 else 0, None))):
        part = blocks[:, lines].swapaxes(1, 2).reshape(rows, columns, -1, 3)
        furthest = np.abs(part - ground).sum(axis=3).argmax(axis=2)
        extreme = np.take_along_axis(part, furthest[:, :, None, None], axis=2)[:, :, 0]
        made[half::2] = (part.mean(axis=2) + extreme) / 2
    return made


def _most_frequent(pixels: Array) -> Array:
    flat = pixels.reshape(-1, 3)[::7].astype(np.int64)
    values, counts = np.unique(flat[:, 0] << 16 | flat[:, 1] << 8 | flat[:, 2], return_counts=True)
    value = int(values[counts.argmax()])
    return np.array([value >> 16, value >> 8 & 255, value & 255])


def _cell(top: Array, bottom: Array) -> Segment:
    upper, lower = (Color.from_rgb(*map(int, colour)) for colour in (top, bottom))
    return Segment("▀", Style(color=upper, bgcolor=lower))
