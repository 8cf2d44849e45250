"""A picture made of pixels, drawn with whatever characters the terminal has.

A canvas has two layers, `base` (colours 0xRRGGBB that stay) and `sprites` (what moves over it), and characters over cells.
It knows which rows of them differ from what was shown last, so that a window draws only those again. Plain lists on purpose:
a frame changes a handful of pixels, and numpy would cost the first frame 120 ms and 12 MB.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import groupby
from operator import itemgetter

from rich.segment import Segment

from day6_tui.appearance.colours import Colours, contrasting, pixel_style

PIXELS_PER_CELL = {"half": (1, 2), "braille": (2, 4), "cell": (1, 1), "ascii": (1, 1)}
"""Pixels across and down in one cell."""

_BRAILLE_BITS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))


@dataclass(frozen=True)
class Mark:
    """A character over a cell; without a background of its own it takes the picture's."""

    char: str
    foreground: int
    background: int | None = None


class PixelCanvas:
    """`columns` x `rows` cells of pixels. All coordinates of pixels count from the top left corner."""

    def __init__(self, columns: int, rows: int, mode: str, background: int, *, colourless: bool = False) -> None:
        self.columns, self.rows, self.mode = columns, rows, mode
        self.colourless = colourless
        self.across, self.down = PIXELS_PER_CELL[mode]
        self.width, self.height = columns * self.across, rows * self.down
        self.background = background
        self.base = [background] * (self.width * self.height)
        self.sprites: dict[int, int] = {}
        self.marks: dict[tuple[int, int], Mark] = {}
        self._dirty: set[int] = set(range(rows))
        """Rows of cells that changed."""

    # -- changing ------------------------------------------------------------------------------------------------------

    def set_base(self, x: int, y: int, rgb: int) -> None:
        """Colour a pixel of the lower layer."""
        index = y * self.width + x
        if self.base[index] != rgb:
            self.base[index] = rgb
            self._dirty.add(self._row(index))

    def set_sprites(self, sprites: dict[int, int]) -> None:
        """Replace the upper layer: colours by pixel index (y * width + x)."""
        old = self.sprites
        if sprites == old:
            return
        for index in old.keys() | sprites.keys():
            if old.get(index) != sprites.get(index):
                self._dirty.add(self._row(index))
        self.sprites = sprites

    def set_marks(self, marks: dict[tuple[int, int], Mark]) -> None:
        """Replace the characters that lie over cells: by (column, row)."""
        old = self.marks
        for place in old.keys() | marks.keys():
            if old.get(place) != marks.get(place):
                self._dirty.add(place[1])
        self.marks = marks

    def fill(self, background: int) -> None:
        """Wipe the lower layer."""
        self.background = background
        self.base = [background] * (self.width * self.height)
        self._dirty = set(range(self.rows))

    def _row(self, index: int) -> int:
        return index // self.width // self.down

    def index(self, x: int, y: int) -> int | None:
        """The index of a pixel, None outside."""
        return y * self.width + x if 0 <= x < self.width and 0 <= y < self.height else None

    def take_changes(self) -> set[int]:
        """The rows of cells that changed since the last call."""
        changed, self._dirty = self._dirty, set()
        return changed

    # -- drawing -------------------------------------------------------------------------------------------------------

    def pixel(self, x: int, y: int) -> int:
        """The visible colour of a pixel."""
        index = y * self.width + x
        return self.sprites.get(index, self.base[index])

    def line(self, row: int) -> list[Segment]:
        """The segments of one line of cells."""
        cells = self._plain_cells(row) if self.colourless else _CELLS[self.mode](self, row)
        if any(place[1] == row for place in self.marks):
            cells = self._with_marks(row, cells)
        return runs(cells)

    def _pixels(self, y: int) -> list[int]:
        start = y * self.width
        pixels = self.base[start : start + self.width]
        if self.sprites:
            for index, rgb in self.sprites.items():
                if start <= index < start + self.width:
                    pixels[index - start] = rgb
        return pixels

    def _half_cells(self, row: int) -> list[tuple[str, int, int]]:
        top, bottom = self._pixels(2 * row), self._pixels(2 * row + 1)
        return [(" ", -1, a) if a == b else ("▀", a, b) for a, b in zip(top, bottom, strict=True)]

    def _braille_cells(self, row: int) -> list[tuple[str, int, int]]:
        lines = [self._pixels(4 * row + k) for k in range(4)]
        background, sprites = self.background, self.sprites
        cells = []
        for column in range(self.columns):
            bits, colour, over = 0, -1, False
            for k, line in enumerate(lines):
                for side in (0, 1):
                    x = 2 * column + side
                    if line[x] != background:
                        bits |= _BRAILLE_BITS[k][side]
                        sprite = sprites and (4 * row + k) * self.width + x in sprites
                        if colour < 0 or (sprite and not over):
                            colour, over = line[x], bool(sprite)
            cells.append((chr(0x2800 + bits), colour, background) if bits else (" ", -1, background))
        return cells

    def _cell_cells(self, row: int) -> list[tuple[str, int, int]]:
        return [(" ", -1, rgb) for rgb in self._pixels(row)]

    def _ascii_cells(self, row: int) -> list[tuple[str, int, int]]:
        background = self.background
        return [(" ", -1, background) if rgb == background else ("*", rgb, background) for rgb in self._pixels(row)]

    def _plain_cells(self, row: int) -> list[tuple[str, int, int]]:
        """Without colour a pixel is there or not."""
        if self.mode in ("cell", "ascii"):
            return [("*" if rgb != self.background else " ", -1, -1) for rgb in self._pixels(row)]
        if self.mode == "braille":
            return [(char, -1, -1) for char, _, _ in self._braille_cells(row)]
        top, bottom = self._pixels(2 * row), self._pixels(2 * row + 1)
        empty = self.background
        return [(" ▄▀█"[2 * (a != empty) + (b != empty)], -1, -1) for a, b in zip(top, bottom, strict=True)]

    def _with_marks(self, row: int, cells: list[tuple[str, int, int]]) -> list[tuple[str, int, int]]:
        for (column, line), mark in self.marks.items():
            if line == row and 0 <= column < self.columns:
                _, foreground, background = cells[column]
                if mark.background is not None:
                    background = mark.background
                elif foreground >= 0 and background == self.background:
                    background = self.background
                colour = mark.foreground if mark.foreground >= 0 else contrasting(background)
                cells[column] = (mark.char, colour, background)
        if self.colourless:
            return [(char, -1, -1) for char, _, _ in cells]
        return cells


_CELLS = {
    "half": PixelCanvas._half_cells,
    "braille": PixelCanvas._braille_cells,
    "cell": PixelCanvas._cell_cells,
    "ascii": PixelCanvas._ascii_cells,
}


def runs(cells: Iterable[tuple[str, int, int]]) -> list[Segment]:
    """Join cells (character, foreground, background) of equal colours into one segment with a shared style."""
    return [
        Segment("".join([char for char, _, _ in run]), pixel_style(*colours))
        for colours, run in groupby(cells, itemgetter(1, 2))
    ]


def square(width: int, height: int) -> tuple[int, int]:
    """Columns and rows of the largest square (a cell is twice as high as wide) in `width` x `height` cells."""
    rows = max(1, min(height, width // 2))
    return max(2, min(width, rows * 2)), rows


def new_canvas(columns: int, rows: int, mode: str, background: int, colours: Colours) -> PixelCanvas:
    """A canvas for the present colours."""
    return PixelCanvas(columns, rows, mode, background, colourless=colours.colourless)
