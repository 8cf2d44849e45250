"""Kitty's graphics protocol: an image per band of the picture, placed wherever a piece of it is visible.

https://sw.kovidgoyal.net/kitty/graphics-protocol/
"""

from __future__ import annotations

import zlib
from base64 import standard_b64encode
from collections.abc import Iterable, Sequence

import numpy as np

from day6_tui.pixels.bands import Array, BandPiece

FIRST_ID = 0x64617900
"""Images of ours have numbers from here on: another program's, left in the same terminal, are not touched."""

CHUNK = 4096
"""Characters that one sequence may carry."""

LEVEL = 1
"""Of zlib: higher ones take two to five times as long for a tenth less."""


class Kitty:
    """Writes bands as images. A changed band gets a new image before the old one goes, so that nothing flickers."""

    keeps = True
    """Whether the terminal keeps pictures that only have to be placed again."""
    seams = False

    def __init__(self) -> None:
        self._images: dict[int, int] = {}
        """The image that shows a band."""

    def draw(self, band: int, pixels: Array, cell: tuple[int, int], pieces: Sequence[BandPiece], changed: bool) -> str:
        """Show the pieces of a band; `changed` says that its pixels are new, `cell` how many of them make a cell."""
        old = self._images.get(band)
        if old is not None and not changed:
            return f"\x1b_Ga=d,d=i,i={old},q=2\x1b\\" + _placed(old, cell, pieces)
        first, second = _both(band)
        new = self._images[band] = second if old == first else first
        text = transmitted(new, pixels) + _placed(new, cell, pieces)
        return text if old is None else text + deleted(old)

    def erase(self, bands: Iterable[int]) -> str:
        """Remove these bands from the screen and from the terminal's memory."""
        return "".join(deleted(self._images.pop(band)) for band in list(bands) if band in self._images)

    def erase_all(self) -> str:
        """Remove everything of ours, also the image that a drawing has left which was cut short."""
        bands = list(self._images)
        self._images.clear()
        return "".join(deleted(number) for band in bands for number in _both(band))


def _both(band: int) -> tuple[int, int]:
    """The images that show a band in turns."""
    first = FIRST_ID + 2 * band
    return first, first + 1


def transmitted(number: int, pixels: Array) -> str:
    """The sequences that hand over an image: height x width x 3 bytes."""
    height, width = pixels.shape[:2]
    data = standard_b64encode(zlib.compress(np.ascontiguousarray(pixels).data, LEVEL)).decode()
    chunks = [data[start : start + CHUNK] for start in range(0, len(data), CHUNK)]
    head = f"a=t,f=24,o=z,t=d,i={number},s={width},v={height},q=2,"
    last = len(chunks) - 1
    return "".join(
        f"\x1b_G{head if place == 0 else ''}m={int(place != last)};{chunk}\x1b\\" for place, chunk in enumerate(chunks)
    )


def deleted(number: int) -> str:
    """The sequence that removes an image with its data."""
    return f"\x1b_Ga=d,d=I,i={number},q=2\x1b\\"


def _placed(number: int, cell: tuple[int, int], pieces: Sequence[BandPiece]) -> str:
    across, down = cell
    return "".join(
        f"\x1b[{piece.row + 1};{piece.column + 1}H"
        f"\x1b_Ga=p,i={number},p={place},x={piece.left * across},y={piece.top * down},"
        f"w={piece.columns * across},h={piece.rows * down},c={piece.columns},r={piece.rows},C=1,q=2\x1b\\"
        for place, piece in enumerate(pieces, 1)
    )
