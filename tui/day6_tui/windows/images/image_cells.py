"""An image in characters: half blocks with two pixels each, coloured cells on a console, letters by brightness without UTF-8."""

from __future__ import annotations

from typing import Any

from rich.segment import Segment

from day6_tui.appearance.colours import pixel_style

RAMP = " .:-=+*#%@"
"""From dark to bright."""

KEPT_BITS = 0xF8F8F8
"""Of a colour: a camera's noise would make every cell different from its neighbour, and from the picture before."""


def pixels_in_cells(columns: int, rows: int, canvas: str) -> tuple[int, int]:
    """How many pixels across and down so many cells show; `canvas` is that of a glyph set."""
    return columns, rows * (2 if canvas in ("half", "braille") else 1)


def in_cells(pixels: Any, canvas: str, *, colourless: bool) -> list[list[Segment]]:
    """The lines of an image (height x width x 3, uint8), which are as wide as it."""
    import numpy as np

    wide = pixels.astype(np.int32)
    if canvas in ("half", "braille") and not colourless:
        colours = _numbers(wide)
        if len(colours) % 2:
            colours = np.vstack([colours, colours[-1:]])
        return [
            _runs([(" ", -1, a) if a == b else ("▀", a, b) for a, b in zip(top, bottom, strict=True)])
            for top, bottom in zip(colours[::2].tolist(), colours[1::2].tolist(), strict=True)
        ]
    if canvas in ("half", "braille"):
        wide = wide[::2]
    bright = (wide @ np.array([299, 587, 114]) * len(RAMP) // 256_000).tolist()
    colours = _numbers(wide).tolist()
    lines = []
    for shades, line in zip(bright, colours, strict=True):
        if colourless:
            lines.append(_runs([(RAMP[shade], -1, -1) for shade in shades]))
        elif canvas == "ascii":
            lines.append(_runs([(RAMP[shade], colour, 0) for shade, colour in zip(shades, line, strict=True)]))
        else:
            lines.append(_runs([(" ", -1, colour) for colour in line]))
    return lines


def on_ground(pixels: Any, size: tuple[int, int], cell: tuple[int, int], ground: int) -> tuple[Any, tuple[int, int]]:
    """An image in the middle of `size` cells of `cell` pixels, and the cell of its upper left corner (column, row).

    It lies on the grid of cells, so that the mouse finds its pixels.
    """
    import numpy as np

    whole = np.empty((size[1] * cell[1], size[0] * cell[0], 3), np.uint8)
    whole[:] = (ground >> 16 & 255, ground >> 8 & 255, ground & 255)
    left = max(0, whole.shape[1] - pixels.shape[1]) // 2 // cell[0]
    top = max(0, whole.shape[0] - pixels.shape[0]) // 2 // cell[1]
    place = whole[top * cell[1] :, left * cell[0] :][: pixels.shape[0], : pixels.shape[1]]
    place[:] = pixels[: place.shape[0], : place.shape[1]]
    return whole, (left, top)


def _numbers(wide: Any) -> Any:
    return (wide[..., 0] << 16 | wide[..., 1] << 8 | wide[..., 2]) & KEPT_BITS


def _runs(cells: list[tuple[str, int, int]]) -> list[Segment]:
    """Join cells of equal colours."""
    segments: list[Segment] = []
    text, before = "", (-2, -2)
    for char, foreground, background in cells:
        if (foreground, background) != before:
            if text:
                segments.append(Segment(text, pixel_style(*before)))
            text, before = "", (foreground, background)
        text += char
    if text:
        segments.append(Segment(text, pixel_style(*before)))
    return segments
