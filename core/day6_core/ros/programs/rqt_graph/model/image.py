"""A laid-out graph as a picture file: SVG, PDF, or PNG and the other formats Pillow writes. Black on white, as in rqt_graph."""

from __future__ import annotations

import html
import io
import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from day6_core.parts import part
from day6_core.ros.programs.rqt_graph.model.ink import FONT_SIZE, INK, Arrow, Ellipse, InkLine, InkText, Point, Stroke
from day6_core.ros.programs.rqt_graph.model.pdf import as_pdf
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Cell, LaidOutGraph, Rect
from day6_core.session.harmless import one_line
from day6_core.whole_file import replace_file

CELL = (9, 20)
"""Pixels of a terminal cell in the picture."""

MARGIN = 12
DEPTH = 5
"""Pixels by which a group's box stands out."""

FRAME, WARNING = "#808080", "#ff0000"
PILLOW_FORMATS = (".png", ".bmp", ".jpg", ".tiff")

MOST_PIXELS = 60_000_000
"""Of a picture: more take too much memory (three bytes each)."""

NO_COLOURS: Mapping[str, str] = {}


def write_image(picture: LaidOutGraph, path: Path, colours: Mapping[str, str] = NO_COLOURS) -> None:
    """Write a picture file; its suffix says which kind. `colours` (#rrggbb) by the keys of boxes that are not black.

    Raises OSError, and ValueError for an unknown suffix or a picture too large for pixels.
    """
    check_suffix(path)
    suffix = path.suffix.lower()
    strokes = list(_strokes(picture, colours))
    width, height = picture.width * CELL[0] + 2 * MARGIN, picture.height * CELL[1] + 2 * MARGIN
    if suffix == ".svg":
        replace_file(path, _svg(strokes, width, height).encode("utf-8"))
    elif suffix == ".pdf":
        replace_file(path, as_pdf(strokes, width, height))
    elif width * height > MOST_PIXELS:
        raise ValueError(f"'{path.name}': {width} x {height} pixels are too many; .svg and .pdf have no limit")
    else:
        replace_file(path, _pixels(strokes, width, height, suffix))


def check_suffix(path: Path) -> None:
    """Raise ValueError for a file that is neither a graph (`.dot`) nor a picture."""
    if path.suffix.lower() not in (".dot", ".svg", ".pdf", *PILLOW_FORMATS):
        raise ValueError(f"'{path.name}': .dot, .svg, .pdf, {', '.join(PILLOW_FORMATS)}")


def _strokes(picture: LaidOutGraph, colours: Mapping[str, str]) -> Iterator[Stroke]:
    for name, rect in picture.clusters:
        left, top, right, bottom = _corners(rect)
        yield InkLine(((left, top), (right, top), (right, bottom), (left, bottom), (left, top)), FRAME)
        yield InkText((left + 4, top + CELL[1] / 2), name, FRAME, False)
    for route in picture.routes:
        if len(route.cells) > 1:
            yield InkLine(tuple(_bends(route.cells)), INK)
        if route.cells and picture.boxes[route.edge.end][0].shape != "text":
            yield _arrow(route.cells)
        if route.label_at is not None:
            x, y = _middle(route.label_at)
            yield InkText((x - CELL[0] / 2, y - CELL[1] / 2), route.edge.label, INK, False)
    for box, rect in picture.boxes.values():
        yield from _box(box, rect, colours.get(box.key, INK))


def _box(box: Box, rect: Rect, colour: str) -> Iterator[Stroke]:
    left, top, right, bottom = _corners(rect)
    top, bottom = top + 2, bottom - 2
    if box.shape == "node":
        yield Ellipse((left, top), (right, bottom), colour)
    elif box.shape != "text":
        yield InkLine(((left, top), (right, top), (right, bottom), (left, bottom), (left, top)), colour)
    if box.shape == "group":
        yield InkLine(
            (
                (left, top),
                (left + DEPTH, top - DEPTH),
                (right + DEPTH, top - DEPTH),
                (right + DEPTH, bottom - DEPTH),
                (right, bottom),
            ),
            colour,
        )
        yield InkLine(((right, top), (right + DEPTH, top - DEPTH)), colour)
    for index, line in enumerate(box.lines):
        row = (top + bottom) / 2 + (index - (len(box.lines) - 1) / 2) * CELL[1]
        centred = box.shape != "text"
        yield InkText(((left + right) / 2 if centred else left + CELL[0], row), line, colour, centred)


def _corners(rect: Rect) -> tuple[float, float, float, float]:
    left, top = MARGIN + rect.x * CELL[0], MARGIN + rect.y * CELL[1]
    return left, top, left + rect.width * CELL[0], top + rect.height * CELL[1]


def _middle(cell: Cell) -> Point:
    return MARGIN + (cell[0] + 0.5) * CELL[0], MARGIN + (cell[1] + 0.5) * CELL[1]


def _bends(cells: Sequence[Cell]) -> Iterator[Point]:
    """Yield the ends of a line and the points where it turns."""
    yield _middle(cells[0])
    for before, at, after in zip(cells, cells[1:], cells[2:], strict=False):
        if (at[0] - before[0], at[1] - before[1]) != (after[0] - at[0], after[1] - at[1]):
            yield _middle(at)
    yield _middle(cells[-1])


def _arrow(cells: Sequence[Cell]) -> Arrow:
    x, y = _middle(cells[-1])
    ahead = 1 if len(cells) < 2 or cells[-1][0] >= cells[-2][0] else -1
    tip = x + ahead * CELL[0] * 0.9
    return Arrow(((tip, y), (tip - ahead * 9, y - 4), (tip - ahead * 9, y + 4)))


# -- SVG ---------------------------------------------------------------------------------------------------------------


def _svg(strokes: Sequence[Stroke], width: int, height: int) -> str:
    body = "\n".join(_element(stroke) for stroke in strokes)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
        f'font-family="monospace" font-size="{FONT_SIZE}" fill="none" stroke-width="1.2">\n'
        f'<rect width="100%" height="100%" fill="#ffffff"/>\n{body}\n</svg>\n'
    )


def _element(stroke: Stroke) -> str:
    if isinstance(stroke, Ellipse):
        (left, top), (right, bottom) = stroke.corner, stroke.opposite
        radii = f'rx="{(right - left) / 2:g}" ry="{(bottom - top) / 2:g}"'
        return f'<ellipse cx="{(left + right) / 2:g}" cy="{(top + bottom) / 2:g}" {radii} stroke="{stroke.colour}"/>'
    if isinstance(stroke, InkText):
        anchor = ' text-anchor="middle"' if stroke.centred else ""
        place = f'x="{stroke.at[0]:g}" y="{stroke.at[1] + FONT_SIZE * 0.35:g}"'
        return f'<text {place}{anchor} fill="{stroke.colour}">{html.escape(one_line(stroke.text))}</text>'
    points = " ".join(f"{x:g},{y:g}" for x, y in stroke.points)
    if isinstance(stroke, Arrow):
        return f'<polygon points="{points}" fill="{INK}"/>'
    return f'<polyline points="{points}" stroke="{stroke.colour}"/>'


# -- pixels ------------------------------------------------------------------------------------------------------------


def _pixels(strokes: Sequence[Stroke], width: int, height: int, suffix: str) -> bytes:
    images, drawing, fonts = (
        part(f"PIL.{each}", f"{suffix} files need") for each in ("Image", "ImageDraw", "ImageFont")
    )
    scale = 2 if 4 * width * height <= MOST_PIXELS else 1  # twice as large, as the real tool saves it
    image = images.new("RGB", (width * scale, height * scale), "white")
    draw = drawing.Draw(image)
    font = fonts.load_default(FONT_SIZE * scale * 0.95)
    for stroke in strokes:
        if isinstance(stroke, Ellipse):
            draw.ellipse(
                [*_scaled(stroke.corner, scale), *_scaled(stroke.opposite, scale)], outline=stroke.colour, width=2
            )
        elif isinstance(stroke, InkText):
            place = (stroke.at[0] * scale, stroke.at[1] * scale)
            draw.text(
                place, one_line(stroke.text), fill=stroke.colour, font=font, anchor="mm" if stroke.centred else "lm"
            )
        elif isinstance(stroke, Arrow):
            draw.polygon([_scaled(point, scale) for point in stroke.points], fill=INK)
        else:
            draw.line([_scaled(point, scale) for point in stroke.points], fill=stroke.colour, width=2)
    buffer = io.BytesIO()
    image.save(buffer, format={".jpg": "JPEG"}.get(suffix, suffix[1:].upper()))
    return buffer.getvalue()


def _scaled(point: Point, scale: int) -> tuple[int, int]:
    return math.floor(point[0] * scale), math.floor(point[1] * scale)
