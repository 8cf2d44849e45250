"""The picture of one terminal: its screen and scrollback as segments, and which cells changed since the last frame."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from rich.segment import Segment
from rich.style import Style

from day6_tui.tui.colours import Colours, pixel_style

# Ubuntu's terminal palette (the Tango colours), by pyte's names; 'brown' is the VT's word for yellow.
_PALETTE = {
    "black": 0x2E3436,
    "red": 0xE0523F,
    "green": 0x7FBF3F,
    "brown": 0xD0A215,
    "blue": 0x6FA4E0,
    "magenta": 0xB48EC0,
    "cyan": 0x34B5B8,
    "white": 0xD3D7CF,
    "brightblack": 0x8A8D88,
    "brightred": 0xFF6B5A,
    "brightgreen": 0x9BE04A,
    "brightbrown": 0xFCE94F,
    "brightyellow": 0xFCE94F,
    "brightblue": 0x8FBDF0,
    "brightmagenta": 0xD2A6DC,
    "brightcyan": 0x5FE0E0,
    "brightwhite": 0xFFFFFF,
}
_PALETTE_ON_LIGHT = {
    **_PALETTE,
    "red": 0xB00000,
    "green": 0x2E6B00,
    "brown": 0x7A5B00,
    "blue": 0x1F4F9F,
    "magenta": 0x6A3A76,
    "cyan": 0x046A6C,
    "white": 0x4A4F4A,
    "brightred": 0xD01010,
    "brightgreen": 0x3C7D00,
    "brightbrown": 0x8A6A00,
    "brightyellow": 0x8A6A00,
    "brightblue": 0x2A62B8,
    "brightmagenta": 0x7E4A8A,
    "brightcyan": 0x057B7E,
    "brightwhite": 0x000000,
}
_SIXTEEN_NAMES = {"brown": "yellow", "brightbrown": "bright_yellow"}

Row = Sequence[Any]
"""One line of pyte characters: data, fg, bg, bold, italics, underscore, strikethrough, reverse, blink."""


class Span(NamedTuple):
    """Cells from `first` to before `end` in a line of the view."""

    line: int
    first: int
    end: int


@lru_cache(maxsize=2048)
def _style(attributes: tuple[Any, ...], colours: Colours) -> Style:
    """The shared style for a character's attributes (all of pyte's but the character itself)."""
    fg, bg, bold, italics, underscore, strike, reverse, _blink = attributes
    base = colours.terminal
    marks = Style(bold=bold or None, italic=italics or None, underline=underscore or None, strike=strike or None)
    if colours.colourless:
        return base + marks + Style(reverse=reverse or None)
    if colours.name == "sixteen":
        style = base + Style(color=_sixteen(fg), bgcolor=_sixteen(bg)) + marks
        return style + Style(reverse=True) if reverse else style
    palette = _PALETTE if colours.dark else _PALETTE_ON_LIGHT
    if bold and fg != "default" and "bright" + fg in palette:
        fg = "bright" + fg
    style = base + pixel_style(_rgb(fg, palette), _rgb(bg, palette))
    if reverse:
        style = Style(color=style.bgcolor, bgcolor=style.color)
    return style + marks


def _rgb(colour: str, palette: dict[str, int]) -> int:
    if colour == "default":
        return -1
    if colour in palette:
        return palette[colour]
    try:
        return int(colour, 16)
    except ValueError:
        return -1


def _sixteen(colour: str) -> str | None:
    if colour == "default":
        return None
    if colour in _PALETTE:
        return _SIXTEEN_NAMES.get(colour, colour.replace("bright", "bright_"))
    return f"#{colour}" if len(colour) == 6 else None


class TerminalView:
    """Keeps what is on show of one terminal, compares, and tells the spans that differ.

    `scroll` is how many lines the view looks back. `selection` is (line, column) to (line, column), lines counted from the
    beginning of the scrollback, the end excluded.
    """

    def __init__(self, terminal: Any) -> None:
        self.terminal = terminal
        self.scroll = 0
        self.selection: tuple[tuple[int, int], tuple[int, int]] | None = None
        self.news = False
        """Something was printed while nobody could see it."""
        self._rows: list[list[Any]] = []
        self._cursor: tuple[int, int] | None = None
        self._stale = True

    # -- reading the terminal ------------------------------------------------------------------------------------------

    @property
    def columns(self) -> int:
        return int(self.terminal.screen.columns)

    @property
    def lines(self) -> int:
        return int(self.terminal.screen.lines)

    @property
    def history(self) -> Sequence[Any]:
        """Lines that have scrolled away, oldest first."""
        return self.terminal.history  # type: ignore[no-any-return]

    @property
    def cursor(self) -> tuple[int, int] | None:
        """Column and line of the cursor in the view; None while it is hidden or scrolled out of sight."""
        cursor = self.terminal.screen.cursor
        line = cursor.y + self.scroll
        if cursor.hidden or line >= self.lines:
            return None
        return min(cursor.x, self.columns - 1), line

    def stale(self) -> None:
        """Compare nothing next time: everything is new."""
        self._stale = True

    def row(self, line: int) -> Row:
        """The characters of a line of the view."""
        return self._rows[line] if line < len(self._rows) else ()

    def changes(self) -> list[Span]:
        """Take over what the terminal shows now and return the cells that differ from before."""
        screen = self.terminal.screen
        columns, lines = screen.columns, screen.lines
        cursor = self.cursor
        if self._stale or len(self._rows) != lines or (self._rows and len(self._rows[0]) != columns):
            screen.dirty.clear()
            self._rows = [self._read(line, columns) for line in range(lines)]
            self._cursor = cursor
            self._stale = False
            return [Span(line, 0, columns) for line in range(lines)]
        if self.scroll:
            dirty: Iterable[int] = range(lines)
        else:
            dirty = sorted(line for line in screen.dirty if line < lines)
        screen.dirty.clear()
        spans = []
        for line in dirty:
            new, old = self._read(line, columns), self._rows[line]
            if new == old:
                continue
            self._rows[line] = new
            first = next(x for x in range(columns) if new[x] != old[x])
            end = next(x for x in range(columns, 0, -1) if new[x - 1] != old[x - 1])
            # A wide character takes two cells: both halves belong to the span.
            if first and new[first].data == "" or first and old[first].data == "":
                first -= 1
            spans.append(Span(line, first, min(columns, end + 1)))
        if cursor != self._cursor:
            for place in (self._cursor, cursor):
                if place is not None:
                    spans.append(self._around(place))
            self._cursor = cursor
        return spans

    def _around(self, place: tuple[int, int]) -> Span:
        x, line = place
        row = self._rows[line] if line < len(self._rows) else ()
        if 0 < x < len(row) and row[x].data == "":
            x -= 1
        return Span(line, x, min(self.columns, x + 2))

    def cursor_span(self) -> list[Span]:
        """The cells of the cursor (they look different when the focus moves)."""
        return [self._around(self._cursor)] if self._cursor is not None else []

    def _read(self, line: int, columns: int) -> list[Any]:
        row = self._source(line)
        return [row[x] for x in range(columns)]

    def _source(self, line: int) -> Any:
        history = self.history
        index = len(history) - self.scroll + line
        return history[index] if index < len(history) else self.terminal.screen.buffer[index - len(history)]

    # -- scrolling -----------------------------------------------------------------------------------------------------

    def scroll_by(self, lines: int) -> bool:
        """Look back (positive) or forward; True if the view moved."""
        target = max(0, min(len(self.history), self.scroll + lines))
        moved = target != self.scroll
        self.scroll = target
        self._stale = self._stale or moved
        return moved

    def keep_place(self, grown: int) -> None:
        """While looking back, stay at the same lines although `grown` more have scrolled away."""
        if self.scroll and grown > 0:
            self.scroll = min(len(self.history), self.scroll + grown)

    def forget_history(self) -> None:
        """Forget what has scrolled away."""
        self.terminal.clear_history()
        self.scroll = 0
        self.selection = None
        self._stale = True

    # -- drawing -------------------------------------------------------------------------------------------------------

    def segments(self, line: int, colours: Colours, *, focused: bool) -> list[Segment]:
        """One line of the view as segments, with cursor and selection."""
        row = self.row(line)
        if not row:
            return []
        marks = self._marks(line, colours, focused)
        segments: list[Segment] = []
        text: list[str] = []
        current: Style | None = None
        attributes: Any = None
        plain: Style | None = None
        for x, char in enumerate(row):
            if char[1:] != attributes:
                attributes = char[1:]
                plain = _style(attributes, colours)
            style = plain
            if marks and x in marks:
                style = marks[x]
            if style is not current:
                if text:
                    segments.append(Segment("".join(text), current))
                    text = []
                current = style
            text.append(char.data)
        if text:
            segments.append(Segment("".join(text), current))
        return segments

    def _marks(self, line: int, colours: Colours, focused: bool) -> dict[int, Style]:
        marks: dict[int, Style] = {}
        if self.selection is not None:
            (first_line, first), (last_line, last) = sorted(self.selection)
            absolute = len(self.history) - self.scroll + line
            if first_line <= absolute <= last_line:
                start = first if absolute == first_line else 0
                end = last if absolute == last_line else self.columns
                marks = dict.fromkeys(range(start, end), colours.selection)
        cursor = self.cursor
        if cursor is not None and cursor[1] == line:
            style = _CURSOR_FOCUSED if focused else _CURSOR_AWAY
            base = _style(self.row(line)[cursor[0]][1:], colours)
            marks[cursor[0]] = base + style
        return marks

    def selected_text(self) -> str:
        """The selected text, lines without the blanks at their ends."""
        if self.selection is None:
            return ""
        (first_line, first), (last_line, last) = sorted(self.selection)
        history, buffer = self.history, self.terminal.screen.buffer
        found = []
        for absolute in range(first_line, last_line + 1):
            row = history[absolute] if absolute < len(history) else buffer[absolute - len(history)]
            start = first if absolute == first_line else 0
            end = last if absolute == last_line else self.columns
            found.append("".join(row[x].data for x in range(start, end)).rstrip())
        return "\n".join(found)


_CURSOR_FOCUSED = Style(reverse=True)
_CURSOR_AWAY = Style(underline=True)
