"""Pupils' screens: one, or two beside each other, each below a line of what is known of its pupil.

A screen comes as lines of text with colours, already without any other sequence (`day6_core/classroom/note.py`).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from rich.segment import Segment
from rich.style import Style
from rich.text import Text
from textual.strip import Strip

from day6_core.classroom.note import ROWS, PupilScreen
from day6_core.classroom.roster import PupilRow
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import clip, fit
from day6_tui.windows.classroom.words import ColouredWords


class ScreenPicture:
    """The lines of one picture. Those that are in the one `before`, of the same style, are not read again."""

    def __init__(self, source: PupilScreen, style: Style, before: ScreenPicture | None = None) -> None:
        self.source = source
        self._style = style
        known, lines = before._read if before is not None else {}, source.ansi.split("\n")
        self._read: dict[str, Strip] = {line: known.get(line) or _strip(line, style) for line in lines}
        self._strips = [self._read[line] for line in lines]

    def lines(self, width: int, height: int, top: int = 0, left: int = 0) -> list[list[Segment]]:
        """Return the part from row `top` and column `left`, filled up to `width`; at most `height` lines."""
        return [
            list(strip.crop(left, left + width).adjust_cell_length(width, self._style))
            for strip in self._strips[top : top + max(0, height)]
        ]


class Sight(NamedTuple):
    """What is seen of one pupil: the row of the roster, something to tell above the screen, whether the teacher types there."""

    row: PupilRow
    remark: ColouredWords | None = None
    is_typed_at: bool = False


class Screens:
    """Draws them all from the same row and column, `top` and `left`."""

    def __init__(self, look: Look) -> None:
        self._look = look
        self._pictures: dict[str, ScreenPicture] = {}
        self.top = self.left = 0
        self.page = 1
        """Rows of a screen that were seen."""
        self.beyond = ""
        """Arrows to where a screen goes on beyond what was seen."""

    def restyle(self) -> None:
        """Colours have changed."""
        self._pictures.clear()

    def scroll(self, rows: int = 0, columns: int = 0) -> None:
        """Look further down or to the right; `draw` keeps it within the screens."""
        self.top, self.left = max(0, self.top + rows), max(0, self.left + columns)

    def scroll_home(self) -> None:
        """Look at the upper left corner."""
        self.top = self.left = 0

    def scroll_end(self) -> None:
        """Look at the lower left corner, where a terminal goes on."""
        self.top, self.left = ROWS[1], 0

    def draw(self, sights: Sequence[Sight], width: int, height: int) -> list[list[Segment]]:
        """Return exactly `height` lines of `width` cells for one pupil or two."""
        if len(sights) == 1:
            self._keep_within(sights, width, height)
            return self._draw(sights[0], width, height)
        half = (width - 1) // 2
        self._keep_within(sights, half, height)
        left, right = (self._draw(sight, half, height) for sight in sights)
        bar = Segment(self._look.glyphs.border.vertical, self._look.colours.frame)
        return [[*a, bar, *b] for a, b in zip(left, right, strict=True)]

    def _keep_within(self, sights: Sequence[Sight], width: int, height: int) -> None:
        """The largest screen decides how far there is to go."""
        screens = [sight.row.note.screen for sight in sights if sight.row.note is not None]
        known = [screen for screen in screens if screen is not None]
        self.page = max(1, height - 1 - any(sight.remark is not None for sight in sights))
        below = max(0, max((screen.rows for screen in known), default=0) - self.page)
        beside = max(0, max((screen.columns for screen in known), default=0) - width)
        self.top, self.left = min(self.top, below), min(self.left, beside)
        ways = {"←": self.left > 0, "↑": self.top > 0, "↓": self.top < below, "→": self.left < beside}
        self.beyond = "".join(arrow for arrow, is_open in ways.items() if is_open)

    def _draw(self, sight: Sight, width: int, height: int) -> list[list[Segment]]:
        colours, ellipsis = self._look.colours, self._look.glyphs.ellipsis
        head = fit(clip("  ".join(self._facts(sight.row)), width, ellipsis), width)
        lines = [[Segment(head, colours.error if sight.is_typed_at else colours.strong)]]
        if sight.remark is not None:
            lines.append([Segment(fit(clip(sight.remark.text, width, ellipsis), width), sight.remark.style)])
        lines += self._screen(sight.row, width, height - len(lines))
        return [*lines, *([[Segment(" " * width, colours.text)]] * height)][:height]

    def _facts(self, row: PupilRow) -> list[str]:
        """What there is to know besides the screen."""
        texts, note, facts = self._look.texts, row.note, [row.name]
        if row.raised is not None:
            facts.append(texts("teacher.state.hand_now"))
        if note is not None and note.lesson is not None:
            title = note.lesson.title.get(texts.language) or note.lesson.name
            facts.append(f"{title} {note.lesson.step}/{note.lesson.all}")
            if note.lesson.hints:
                facts.append(texts("teacher.hints", count=note.lesson.hints))
        if note is not None and note.trouble is not None:
            facts.append(note.trouble.line)
        return facts

    def _screen(self, row: PupilRow, width: int, height: int) -> list[list[Segment]]:
        texts, colours = self._look.texts, self._look.colours
        screen = row.note.screen if row.note is not None and row.is_here else None
        if screen is None:
            waiting = texts("teacher.no_screen" if row.is_here else "teacher.state.gone")
            text = clip(f" {waiting}", width, self._look.glyphs.ellipsis)
            return [[Segment(fit(text, width), colours.muted)]]
        picture = self._pictures.get(row.name)
        if picture is None or picture.source is not screen:
            picture = self._pictures[row.name] = ScreenPicture(screen, colours.terminal, picture)
        top = min(self.top, max(0, screen.rows - height))
        left = min(self.left, max(0, screen.columns - width))
        seen = min(width, screen.columns - left)
        beside = Segment(" " * (width - seen), colours.text)
        return [[*line, beside] for line in picture.lines(seen, height, top, left)]


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
