"""Strokes as a PDF of one page, as large as the drawing: lines that stay sharp, and text that can be searched and copied.

Of three libraries, measured with Python 3.11 on Linux x86-64 (Pillow is needed for PNG anyway and is not counted):

| library         | installed, download          | import          | licence | Chinese text                                   |
| --------------- | ---------------------------- | --------------- | ------- | ---------------------------------------------- |
| reportlab 5.1.0 | 10.5 MB, 2.3 MB (no C code)  | 51 ms, 14.5 MB  | BSD     | by the names of Adobe's Asian fonts, no file   |
| fpdf2 2.8.9     | 34.0 MB, 6.1 MB (fonttools)  | 190 ms, 38.3 MB | LGPL    | only with a font file, of which it embeds parts |
| Pillow 13.0.0   | 0                            | 32 ms, 8.9 MB   | MIT-CMU | pixels of a font file: nothing can be searched |

So it is reportlab, imported when the first PDF is written. Chinese and Korean are written in fonts that the file names and does
not contain, as the PDF standard provides: a viewer takes its own font for them, and one without any leaves them out.
"""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator
from functools import cache
from itertools import groupby
from typing import TYPE_CHECKING

from day6_core.parts import part
from day6_core.ros.programs.rqt_graph.model.ink import FONT_SIZE, INK, Arrow, Ellipse, InkText, Stroke
from day6_core.session.harmless import one_line

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas

POINTS = 0.75
"""Points of a pixel."""

LONGEST = 14_400.0
"""Points of a page's side, at most (ISO 32000-1, Annex C): a larger drawing is scaled down to it."""

LATIN = "Courier"
FONTS = (("cp1252", LATIN), ("gbk", "STSong-Light"), ("cp949", "HYSMyeongJo-Medium"))
"""The characters a font has, as the encoding of the same characters. Every viewer has the first one."""


def as_pdf(strokes: Iterable[Stroke], width: int, height: int) -> bytes:
    """Return the file of a drawing of `width` x `height` pixels; see `written` for what stands in it. Raises OSError."""
    canvas_module = part("reportlab.pdfgen.canvas", "PDF files need")
    scale = min(POINTS, LONGEST / width, LONGEST / height)
    buffer = io.BytesIO()
    canvas: Canvas = canvas_module.Canvas(buffer, pagesize=(width * scale, height * scale), pageCompression=1)
    canvas.setTitle("")
    canvas.scale(scale, scale)
    canvas.setLineWidth(1.2)
    for stroke in strokes:
        _draw(canvas, stroke, height)
    canvas.showPage()
    canvas.save()
    return buffer.getvalue()


def written(text: str) -> str:
    """Return a text as it stands in the file: what no font has, and what is no sign, is written as an escape."""
    return "".join(char if _font(char) else ascii(char)[1:-1] for char in one_line(text))


def _draw(canvas: Canvas, stroke: Stroke, height: int) -> None:
    if isinstance(stroke, InkText):
        _write(canvas, stroke, height)
    elif isinstance(stroke, Ellipse):
        canvas.setStrokeColor(stroke.colour)
        (left, top), (right, bottom) = stroke.corner, stroke.opposite
        canvas.ellipse(left, height - top, right, height - bottom)
    else:
        path = canvas.beginPath()
        (x, y), *rest = stroke.points
        path.moveTo(x, height - y)
        for x, y in rest:
            path.lineTo(x, height - y)
        if isinstance(stroke, Arrow):
            canvas.setFillColor(INK)
            canvas.drawPath(path, stroke=0, fill=1)
        else:
            canvas.setStrokeColor(stroke.colour)
            canvas.drawPath(path)


def _write(canvas: Canvas, text: InkText, height: int) -> None:
    runs = list(_runs(written(text.text)))
    widths = [canvas.stringWidth(run, font, FONT_SIZE) for font, run in runs]
    x = text.at[0] - (sum(widths) / 2 if text.centred else 0)
    canvas.setFillColor(text.colour)
    for (font, run), width in zip(runs, widths, strict=True):
        canvas.setFont(font, FONT_SIZE)
        canvas.drawString(x, height - text.at[1] - FONT_SIZE * 0.35, run)
        x += width


def _runs(text: str) -> Iterator[tuple[str, str]]:
    """Yield the fonts of a text, each with what is written in it."""
    for font, run in groupby(text, key=_font):
        if font != LATIN:
            _register(font)
        yield font, "".join(run)


@cache
def _register(font: str) -> None:
    from reportlab.pdfbase.cidfonts import UnicodeCIDFont
    from reportlab.pdfbase.pdfmetrics import registerFont

    registerFont(UnicodeCIDFont(font))


@cache
def _font(char: str) -> str:
    for encoding, font in FONTS:
        try:
            char.encode(encoding)
        except UnicodeEncodeError:
            continue
        return font
    return ""
