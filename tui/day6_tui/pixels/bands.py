"""Pictures are sent in bands of a few rows of cells, and of a band the pieces that nothing covers."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray
from textual.geometry import Region

Array = NDArray[Any]
"""Pixels: height x width x 3, red, green and blue as bytes."""


class BandPiece(NamedTuple):
    """Cells of a band that can be seen: where on the screen, and where in the band."""

    column: int
    row: int
    left: int
    top: int
    columns: int
    rows: int


class Writer(Protocol):
    """Writes bands for one kind of terminal."""

    keeps: bool
    seams: bool

    def draw(self, band: int, pixels: Array, cell: tuple[int, int], pieces: list[BandPiece], changed: bool) -> str: ...

    def erase(self, bands: Iterable[int]) -> str: ...

    def erase_all(self) -> str: ...


def pieces_of(region: Region, visible: Iterable[Region]) -> list[BandPiece]:
    """The visible parts of a band that is at `region` of the screen."""
    shared = (region.intersection(each) for each in visible)
    return [
        BandPiece(each.x, each.y, each.x - region.x, each.y - region.y, each.width, each.height)
        for each in shared
        if each
    ]


def changed_cells(before: Array, after: Array, cell: tuple[int, int]) -> Region:
    """The smallest rectangle of cells that contains every pixel in which two pictures of one size differ."""
    different = (before != after).reshape(len(before), -1)
    rows = np.flatnonzero(different.any(axis=1))
    if not len(rows):
        return Region()
    columns = np.flatnonzero(different[rows[0] : rows[-1] + 1].any(axis=0)) // 3
    across, down = cell
    left, top = int(columns[0]) // across, int(rows[0]) // down
    return Region(left, top, int(columns[-1]) // across + 1 - left, int(rows[-1]) // down + 1 - top)


def without(region: Region, covers: Iterable[Region]) -> list[Region]:
    """What is left of a rectangle under others, as rectangles."""
    rest = [region]
    for cover in covers:
        rest = [part for each in rest for part in _minus(each, cover)]
    return rest


def _minus(region: Region, cover: Region) -> list[Region]:
    shared = region.intersection(cover)
    if not shared:
        return [region]
    parts = (
        Region(region.x, region.y, region.width, shared.y - region.y),
        Region(region.x, shared.y, shared.x - region.x, shared.height),
        Region(shared.right, shared.y, region.right - shared.right, shared.height),
        Region(region.x, shared.bottom, region.width, region.bottom - shared.bottom),
    )
    return [part for part in parts if part]
