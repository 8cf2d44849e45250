"""From pixels to the cells of a terminal, and which of them changed: half blocks, braille, coloured cells, ASCII."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from rich.cells import cell_len
from rich.segment import Segment

from day6_tui.appearance.colours import pixel_style
from day6_tui.panes.canvas import PIXELS_PER_CELL, runs
from day6_tui.render.label_places import LabelPlaces
from day6_tui.render.picture import EMPTY, LINE, SURFACE, Array, RenderedPicture

RAMP = ".:-=+*#%@"
"""From dark to bright, for surfaces without colour."""

_STROKES = {LINE: "-", LINE + 1: "|", LINE + 2: "/", LINE + 3: "\\"}

_DOTS = np.array([[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]])

PLAIN = -1

READABLE = 70
"""Of 255: how much a text's brightness differs from that of its ground."""

DOTS_LIFT = 1.7
"""How much brighter dots are made than what they show: they cover about so much less of a cell."""


def pixel_aspect(mode: str) -> float:
    """A pixel's width by its height: a cell is twice as high as wide."""
    across, down = PIXELS_PER_CELL[mode]
    return down / across / 2


Label = tuple[int, str, int, int]
"""A text: column, text, its colour and that of the ground."""


@dataclass(eq=False)
class Cells:
    """Characters, each with two colours (0xRRGGBB, -1 for the terminal's own): rows x columns of each."""

    chars: Array
    front: Array
    back: Array
    labels: dict[int, list[Label]]
    """By row."""

    @property
    def size(self) -> tuple[int, int]:
        """Columns and rows."""
        rows, columns = self.chars.shape
        return columns, rows

    def line(self, row: int) -> list[Segment]:
        """One row as segments, equal neighbours joined."""
        chars, fronts, backs = (each[row].tolist() for each in (self.chars, self.front, self.back))
        segments = runs(zip(map(chr, chars), fronts, backs, strict=True))
        return self._with_labels(row, segments) if row in self.labels else segments

    def _with_labels(self, row: int, segments: list[Segment]) -> list[Segment]:
        columns = self.chars.shape[1]
        for column, text, colour, ground in self.labels[row]:
            width = cell_len(text)
            if not 0 <= column <= columns - width:
                continue
            left, right = _cut(segments, column), _cut_after(segments, column + width)
            segments = [*left, Segment(text, pixel_style(colour, ground)), *right]
        return segments

    def changes(self, before: Cells | None) -> list[int]:
        """The rows in which this differs from the cells shown before."""
        if before is None or before.size != self.size:
            return list(range(self.size[1]))
        different = (self.chars != before.chars) | (self.front != before.front) | (self.back != before.back)
        for row in self.labels.keys() | before.labels.keys():
            now, then = {*self.labels.get(row, ())}, {*before.labels.get(row, ())}
            for same in (True, False):  # what is under a text that stays is not seen
                for column, text, _, _ in now & then if same else now ^ then:
                    different[row, column : column + cell_len(text)] = not same
        rows: list[int] = np.flatnonzero(different.any(axis=1)).tolist()
        return rows


def _cut(segments: list[Segment], end: int) -> list[Segment]:
    """The first `end` cells; every character of a picture is one cell wide."""
    left, used = [], 0
    for text, style, _ in segments:
        if used + cell_len(text) > end:
            left.append(Segment(text[: end - used], style))
            break
        left.append(Segment(text, style))
        used += cell_len(text)
    return [segment for segment in left if segment.text]


def _cut_after(segments: list[Segment], start: int) -> list[Segment]:
    right, used = [], 0
    for text, style, _ in segments:
        if used + cell_len(text) > start:
            right.append(Segment(text[max(0, start - used) :], style))
        used += cell_len(text)
    return right


def cells_of(
    picture: RenderedPicture,
    mode: str,
    step: int = 4,
    *,
    colourless: bool = False,
    places: LabelPlaces | None = None,
    grids: RenderedPicture | None = None,
) -> Cells:
    """Convert a picture with `PIXELS_PER_CELL[mode]` pixels per cell to cells; `places` remembers where texts stood.

    `grids` are those of a picture in half blocks, painted for braille.
    """
    across, down = PIXELS_PER_CELL[mode]
    columns, rows = picture.width // across, picture.height // down
    if colourless:
        chars, front, back = _plain(picture, mode, columns, rows)
    else:
        chars, front, back = _MODES[mode](picture, picture.rgb(step).astype(np.int64), columns, rows)
    if grids is not None:
        chars, front, back = _with_dots((chars, front, back), picture, grids, step, colourless=colourless)
    labels: dict[int, list[Label]] = {}
    texts = [text._replace(x=text.x / across, y=text.y / down) for text in picture.labels]
    robot = cells_covered(picture.robot, across, down) if texts else None
    places = places or LabelPlaces(unicode=mode != "ascii")
    for pieces, text in zip(places.place(texts, columns, rows, robot), texts, strict=True):
        red, green, blue = text.colour
        colour = PLAIN if colourless else red << 16 | green << 8 | blue
        for column, row, words in pieces:
            under = back[row, column : column + cell_len(words)]
            if text.is_name and not colourless:
                under = np.full_like(under, chip_of(picture.background))
            labels.setdefault(row, []).append((column, words, colour, _ground(under, colour, picture.background)))
    return Cells(chars, front, back, labels)


def cells_covered(pixels: Array, across: int, down: int) -> Array:
    """The cells of so many pixels in which a pixel is set: rows x columns."""
    rows, columns = pixels.shape[0] // down, pixels.shape[1] // across
    blocks = pixels[: rows * down, : columns * across].reshape(rows, down, columns, across)
    covered: Array = np.any(blocks, axis=(1, 3))
    return covered


def chip_of(background: tuple[int, int, int]) -> int:
    """The ground of names: that of the view, darker, so that lines do not run into them."""
    red, green, blue = (part // 2 for part in background)
    return red << 16 | green << 8 | blue


def _ground(under: Array, colour: int, background: tuple[int, int, int]) -> int:
    """What most cells under a text have, or the background of the view where the text could not be read on that."""
    values = under.tolist()
    ground: int = max(set(values), key=values.count)
    if ground == PLAIN or abs(_brightness(ground) - _brightness(colour)) >= READABLE:
        return ground
    red, green, blue = background
    return red << 16 | green << 8 | blue


def _brightness(colour: int) -> float:
    return 0.3 * (colour >> 16) + 0.59 * (colour >> 8 & 0xFF) + 0.11 * (colour & 0xFF)


Parts = tuple[Array, Array, Array]


def _half(picture: RenderedPicture, rgb: Array, columns: int, rows: int) -> Parts:
    top, bottom = rgb[0 : 2 * rows : 2], rgb[1 : 2 * rows : 2]
    same = top == bottom
    return np.where(same, ord(" "), ord("▀")), np.where(same, PLAIN, top), bottom


def _cell(picture: RenderedPicture, rgb: Array, columns: int, rows: int) -> Parts:
    return np.full(rgb.shape, ord(" ")), np.full(rgb.shape, PLAIN), rgb


def _dots_of(array: Array, columns: int, rows: int) -> Array:
    """What an array of pixels holds for the eight dots of each cell: rows x columns x 8."""
    block: Array = array[: 4 * rows, : 2 * columns].reshape(rows, 4, columns, 2).transpose(0, 2, 1, 3)
    return block.reshape(rows, columns, 8)


def _braille_chars(dots: Array) -> Array:
    bits = (dots * _DOTS.reshape(8)).sum(axis=2)
    chars: Array = np.where(bits > 0, 0x2800 + bits, ord(" "))
    return chars


def _braille(picture: RenderedPicture, rgb: Array, columns: int, rows: int) -> Parts:
    lit = _dots_of(picture.kind, columns, rows) != EMPTY
    colours = _dots_of(rgb, columns, rows)
    red, green, blue = picture.background
    ground = red << 16 | green << 8 | blue
    depth = np.where(lit, _dots_of(picture.depth, columns, rows), np.inf)
    nearest = np.take_along_axis(colours, depth.argmin(axis=2)[..., None], axis=2)[..., 0]
    full = lit.all(axis=2)
    # Dots cover a small part of a cell. Where a surface fills it, its colour fills the ground, too, and the dots are what
    # differs; elsewhere they are made brighter, so that lines are as bright as those of half blocks.
    back = np.where(full, np.take_along_axis(colours, depth.argmax(axis=2)[..., None], axis=2)[..., 0], ground)
    dots = np.where(full[..., None], colours != back[..., None], lit)
    front = np.where(full, nearest, _brighter(nearest))
    return _braille_chars(dots), np.where(dots.any(axis=2), front, PLAIN), back


def _with_dots(parts: Parts, picture: RenderedPicture, grids: RenderedPicture, step: int, *, colourless: bool) -> Parts:
    """The cells of a picture in half blocks, but where those are empty the dots of its grids, painted for braille."""
    chars, front, back = parts
    rows, columns = chars.shape
    dots = (
        _plain(grids, "braille", columns, rows)
        if colourless
        else _braille(grids, grids.rgb(step).astype(np.int64), columns, rows)
    )
    free = ~cells_covered(picture.kind != EMPTY, *PIXELS_PER_CELL["half"]) & (dots[0] != ord(" "))
    chars, front, back = (np.where(free, dot, part) for dot, part in zip(dots, parts, strict=True))
    return chars, front, back


def _brighter(colours: Array) -> Array:
    """Colours (0xRRGGBB) made brighter by `DOTS_LIFT`, or by as much as keeps their hue."""
    parts = np.stack([colours >> 16, colours >> 8 & 0xFF, colours & 0xFF])
    lift = np.minimum(DOTS_LIFT, 255 / np.maximum(1, parts.max(axis=0)))
    red, green, blue = (parts * lift).astype(np.int64)
    result: Array = red << 16 | green << 8 | blue
    return result


def _ascii(picture: RenderedPicture, rgb: Array, columns: int, rows: int) -> Parts:
    chars, drawn = _characters(picture)
    red, green, blue = picture.background
    back = np.full(rgb.shape, red << 16 | green << 8 | blue)
    # Characters are thin: their colour is made brighter, so that dark wheels stand out from the ground.
    bright = np.maximum(picture.colour.max(axis=2), 1e-3)
    lifted = np.clip(picture.colour * np.maximum(1.0, 0.55 / bright)[..., None] * 255, 0, 255).astype(np.int64) & 0xF0
    colours = lifted[..., 0] << 16 | lifted[..., 1] << 8 | lifted[..., 2]
    return chars, np.where(drawn, colours, PLAIN), back


def _characters(picture: RenderedPicture) -> tuple[Array, Array]:
    """A character for every pixel, and whether anything is there."""
    # A bright thing in the shade is as bright as a dark one in the light, as for the eye.
    tone = picture.shade * (0.45 + 0.55 * picture.colour.max(axis=2))
    ramp = np.array([ord(char) for char in RAMP])
    index = np.clip((tone * 1.15 * len(RAMP)).astype(int), 0, len(RAMP) - 1)
    chars = np.where(picture.kind == SURFACE, ramp[index], ord(" "))
    for kind, stroke in _STROKES.items():
        chars = np.where(picture.kind == kind, ord(stroke), chars)
    return chars, picture.kind != EMPTY


def _plain(picture: RenderedPicture, mode: str, columns: int, rows: int) -> Parts:
    none = np.full((rows, columns), PLAIN)
    if mode == "braille":
        return _braille_chars(_dots_of(picture.kind, columns, rows) != EMPTY), none, none
    if mode == "half":
        lit = picture.kind != EMPTY
        top, bottom = lit[0 : 2 * rows : 2], lit[1 : 2 * rows : 2]
        signs = np.array([ord(char) for char in " ▄▀█"])
        return signs[2 * top + bottom], none, none
    return _characters(picture)[0], none, none


_MODES = {"half": _half, "braille": _braille, "cell": _cell, "ascii": _ascii}
