"""Sixel: bands of six rows, one pass per colour, with run lengths. Made with numpy for all bands of a picture at once.

https://vt100.net/docs/vt3xx-gp/chapter14.html
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from day6_tui.pixels.bands import Array
from day6_tui.pixels.inline import Inline

REGISTERS = 256
_STEPS = 32
"""Steps of red, green and blue that are told apart."""


class Palette:
    """Colours in use. A new one gets a register of its own while there are any, then the nearest one's."""

    def __init__(self) -> None:
        self._register = np.full(_STEPS**3, -1, np.int16)
        self._colours = np.zeros((REGISTERS, 3), np.int64)
        self._used = 0

    def registers(self, pixels: Array) -> Array:
        """The register of every pixel."""
        parts = (pixels >> 3).astype(np.int32)
        keys = parts[..., 0] << 10 | parts[..., 1] << 5 | parts[..., 2]
        found = self._register[keys]
        if (found < 0).any():
            self._learn(keys, pixels, found < 0)
            found = self._register[keys]
        result: Array = found
        return result

    def _learn(self, keys: Array, pixels: Array, unknown: Array) -> None:
        new, where, counts = np.unique(keys[unknown], return_index=True, return_counts=True)
        samples = pixels[unknown][where].astype(np.int64)
        order = np.argsort(-counts, kind="stable")
        own, others = order[: REGISTERS - self._used], order[REGISTERS - self._used :]
        numbers = np.arange(self._used, self._used + len(own))
        self._register[new[own]] = numbers
        self._colours[numbers] = samples[own]
        self._used += len(own)
        if len(others):
            difference = samples[others][:, None, :] - self._colours[None, : self._used]
            self._register[new[others]] = (difference**2).sum(axis=2).argmin(axis=1)

    def definition(self, register: int) -> str:
        """The sequence that gives a register its colour, in percent."""
        red, green, blue = (int(part) * 100 // 255 for part in (self._colours[register] + 1).clip(0, 255))
        return f"#{register};2;{red};{green};{blue}"


class Sixel(Inline):
    """Writes pieces with one palette for all of them."""

    def __init__(self, cell: tuple[float, float]) -> None:
        self._cell = cell
        """The terminal's pixels in a cell: Sixel is never scaled."""
        self.seams = cell != (int(cell[0]), int(cell[1]))
        self._palette = Palette()

    def encoded(self, pixels: Array, columns: int, rows: int) -> str:
        return encoded(_scaled(pixels, int(columns * self._cell[0]), int(rows * self._cell[1])), self._palette)


def _scaled(pixels: Array, width: int, height: int) -> Array:
    if pixels.shape[:2] == (height, width):
        return pixels
    rows = np.arange(height) * pixels.shape[0] // height
    columns = np.arange(width) * pixels.shape[1] // width
    result: Array = pixels[rows][:, columns]
    return result


def encoded(pixels: Array, palette: Palette) -> str:
    """A picture as one Sixel sequence; pixels below its last row stay as they are."""
    height, width = pixels.shape[:2]
    registers = palette.registers(pixels)
    used = np.flatnonzero(np.bincount(registers.reshape(-1), minlength=REGISTERS))
    number = np.zeros(REGISTERS, np.int64)
    number[used] = np.arange(len(used))
    colours = number[registers]
    bands = (height + 5) // 6
    bits = np.zeros((bands, len(used), width), np.uint8)
    flat, columns = bits.reshape(-1), np.arange(width)
    for row in range(6):  # the row's colours in all bands at once; each pixel has its own place
        lines = colours[row::6]
        start = np.arange(len(lines))[:, None] * (len(used) * width)
        flat[start + lines * width + columns] |= np.uint8(1 << row)
    definitions = "".join(palette.definition(int(register)) for register in used)
    return f'\x1bP0;1;0q"1;1;{width};{height}{definitions}{_body(bits, used.tolist())}\x1b\\'


def _body(bits: Array, used: list[int]) -> str:
    bands, _, width = bits.shape
    band_of, colour_of = np.nonzero(bits.any(axis=2))
    lines = bits[band_of, colour_of]
    edge = np.ones((len(lines), width + 1), bool)
    edge[:, 1:width] = lines[:, 1:] != lines[:, :-1]
    line_of, place = np.nonzero(edge)
    kept = place[:-1] < width  # the edge at a line's end only closes its last run
    values = lines[line_of[:-1][kept], place[:-1][kept]].tolist()
    lengths = np.diff(place)[kept].tolist()
    runs = [_run(value, length) for value, length in zip(values, lengths, strict=True)]
    ends = np.cumsum(np.bincount(line_of[:-1][kept], minlength=len(lines))).tolist()
    texts: list[list[str]] = [[] for _ in range(bands)]
    first = 0
    for band, colour, end in zip(band_of.tolist(), colour_of.tolist(), ends, strict=True):
        last = end - 1 if values[end - 1] == 0 else end
        texts[band].append(f"#{used[colour]}{''.join(runs[first:last])}")
        first = end
    return "-".join("$".join(passes) for passes in texts)


@lru_cache(maxsize=65536)
def _run(value: int, length: int) -> str:
    char = chr(63 + value)
    return char * length if length < 4 else f"!{length}{char}"
