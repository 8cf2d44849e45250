"""A pupil's screen as lines of segments: text with colours, already without any other sequence (`core/classroom/note.py`)."""

from __future__ import annotations

from itertools import pairwise

from rich.segment import Segment
from rich.style import Style
from rich.text import Text
from textual.strip import Strip

from day6_tui.core.classroom.note import Picture


class ScreenPicture:
    """The lines of one picture."""

    def __init__(self, source: Picture, style: Style) -> None:
        self.source = source
        self._style = style
        self._strips = [_strip(line, style) for line in source.ansi.split("\n")]

    def lines(self, width: int, height: int, top: int = 0) -> list[list[Segment]]:
        """Return the left part of the picture from row `top`, filled up to `width`; at most `height` lines."""
        return [
            list(strip.crop(0, width).adjust_cell_length(width, self._style))
            for strip in self._strips[top : top + max(0, height)]
        ]


def _strip(line: str, style: Style) -> Strip:
    text = Text.from_ansi(line, no_wrap=True, end="")
    segments, plain = [], text.plain
    edges = sorted({0, len(plain), *(edge for span in text.spans for edge in (span.start, span.end))})
    for start, end in pairwise(edges):
        look = style
        for span in text.spans:
            if span.start <= start and end <= span.end and isinstance(span.style, Style):
                look += span.style
        segments.append(Segment(plain[start:end], look))
    return Strip(segments)
