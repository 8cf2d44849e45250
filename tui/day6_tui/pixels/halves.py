"""A picture of real pixels as half blocks, for who sees the screen as text only: a teacher who watches."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np
from rich.color import Color
from rich.segment import Segment
from rich.style import Style
from textual.geometry import Region
from textual.strip import Strip

from day6_tui.pixels.bands import Array


def over(strips: Sequence[Strip], corner: tuple[int, int], visible: Iterable[Region], halves: Array) -> list[Strip]:
    """Return the lines of a screen with the visible parts of a picture on them.

    `corner` is the column and line of the picture, `halves` what `halved` has made of it.
    """
    drawn, (x, y) = list(strips), corner
    pairs = np.concatenate([halves[0::2], halves[1::2]], axis=2)
    for part in visible:
        for line in range(part.y, min(part.bottom, len(drawn))):
            cells = pairs[line - y, part.x - x : part.right - x]
            strip = drawn[line]
            drawn[line] = Strip.join([strip.crop(0, part.x), Strip(_runs(cells)), strip.crop(part.right)])
    return drawn


def _runs(cells: Array) -> list[Segment]:
    """Return a segment for each run of cells with the same two colours."""
    edges = [0, *(np.flatnonzero((cells[1:] != cells[:-1]).any(axis=1)) + 1).tolist(), len(cells)]
    return [Segment("▀" * (end - begin), _style(*map(int, cells[begin]))) for begin, end in pairwise(edges)]


@lru_cache(4096)
def _style(*colours: int) -> Style:
    return Style(color=Color.from_rgb(*colours[:3]), bgcolor=Color.from_rgb(*colours[3:]))


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
