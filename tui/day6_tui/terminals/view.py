"""The view of one terminal: its screen and scrollback as segments, and which lines changed since the last frame."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import repeat
from typing import TYPE_CHECKING, TypeAlias

from rich.cells import cell_len
from rich.segment import Segment
from rich.style import Style

from day6_tui.appearance.colours import Colours, pixel_style

if TYPE_CHECKING:
    from day6_core.shell.screen.cells import Char
    from day6_core.shell.screen.reflow import Marker
    from day6_core.shell.screen.rows import Row
    from day6_core.shell.terminal import Terminal

# Ubuntu's terminal palette (the Tango colours), by the names of `rows.Style`; 'brown' is the VT's word for yellow.
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
# Ubuntu's own: the ones above are lighter, to be read as letters on its violet.
_BACKGROUNDS = {
    **_PALETTE,
    "red": 0xCC0000,
    "green": 0x4E9A06,
    "brown": 0xC4A000,
    "blue": 0x3465A4,
    "magenta": 0x75507B,
    "cyan": 0x06989A,
}
_SIXTEEN_NAMES = {"brown": "yellow", "brightbrown": "bright_yellow"}

LONGEST_LINE = 40
"""Rows of the screen that one line may take, in each direction, when all of it is asked for."""

Attributes: TypeAlias = tuple[str, str, bool, bool, bool, bool, bool, bool]
"""fg, bg, bold, italics, underscore, strikethrough, reverse, blink of a cell."""


Selection: TypeAlias = tuple[tuple[int, int], tuple[int, int]]


@lru_cache(maxsize=2048)
def _style(attributes: Attributes, colours: Colours) -> Style:
    """The shared style for a character's attributes (all of a cell's but the character itself)."""
    fg, bg, bold, italics, underscore, strike, reverse, _blink = attributes
    base = colours.terminal
    marks = Style(bold=bold or None, italic=italics or None, underline=underscore or None, strike=strike or None)
    if colours.colourless:
        return base + marks + Style(reverse=reverse or None)
    if colours.name == "sixteen":
        style = base + Style(color=_sixteen(fg), bgcolor=_sixteen(bg)) + marks
        return style + Style(reverse=True) if reverse else style
    palette = _PALETTE if colours.dark or bg != "default" else _PALETTE_ON_LIGHT
    if bold and fg != "default" and "bright" + fg in palette:
        fg = "bright" + fg
    style = base + pixel_style(_rgb(fg, palette), _rgb(bg, _BACKGROUNDS))
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
    """Keeps what is shown of one terminal, and finds the spans that differ from the last frame.

    Where it looks and what is selected follow the text when another width wraps it anew.
    """

    def __init__(self, terminal: Terminal) -> None:
        self.terminal = terminal
        self._top: Marker | None = None
        """The first line that is shown, while the view looks back."""
        self._selected: tuple[Marker, Marker] | None = None
        self._rows: list[list[Char]] = []
        self._cursor: tuple[int, int] | None = None
        self._stale = True
        self._scrolled = 0
        self.passed = 0
        """Lines that left the screen between the last two updates."""

    # -- reading the terminal ------------------------------------------------------------------------------------------

    @property
    def columns(self) -> int:
        return self.terminal.columns

    @property
    def lines(self) -> int:
        return self.terminal.rows

    @property
    def history(self) -> int:
        """How many lines of the scrollback there are."""
        return len(self.terminal.screen.scrollback)

    @property
    def scroll(self) -> int:
        """How many lines the view looks back."""
        if self._top is None:
            return 0
        return max(0, min(self.history, self.terminal.screen.scrolled - self._top.line))

    @scroll.setter
    def scroll(self, lines: int) -> None:
        self._top = self._marker(self.history - lines, 0) if lines else None

    @property
    def selection(self) -> Selection | None:
        """(line, column) to (line, column), lines counted from the beginning of the scrollback, the end excluded."""
        if self._selected is None:
            return None
        oldest = self._oldest
        first, last = [(mark.line - oldest, mark.column) if mark.line >= oldest else (0, 0) for mark in self._selected]
        return (first, last) if first != last or first != (0, 0) else None

    @selection.setter
    def selection(self, places: Selection | None) -> None:
        self._selected = None if places is None else (self._marker(*places[0]), self._marker(*places[1]))

    def _marker(self, line: int, column: int) -> Marker:
        from day6_core.shell.screen.reflow import Marker

        marker = Marker(self._oldest + line, column)
        self.terminal.screen.markers.add(marker)
        return marker

    @property
    def _oldest(self) -> int:
        """The first line of the scrollback, counted from the first line that the terminal ever showed."""
        return self.terminal.screen.scrolled - self.history

    @property
    def has_more(self) -> bool:
        """Whether the terminal has text that its screen does not show yet."""
        return self.terminal.has_more

    @property
    def is_flooded(self) -> bool:
        """Whether so much of it waits that it should not wait for the next frame."""
        return self.terminal.is_flooded

    @property
    def is_crowded(self) -> bool:
        """Whether so much output is waiting that its programs pause."""
        return self.terminal.is_crowded

    @property
    def at_prompt(self) -> bool:
        """Whether the shell waits for a command."""
        front = self.terminal.discipline.front
        return not self.terminal.busy and front is not None and front.is_raw

    @property
    def reading_keys(self) -> bool:
        """Whether a program (not the shell's line editor) reads single keys."""
        front = self.terminal.discipline.front
        return self.terminal.busy and front is not None and front.is_raw

    @property
    def only_echoes(self) -> bool:
        """Whether a command runs that reads no single keys: they are only shown, as ^[[A for an arrow."""
        front = self.terminal.discipline.front
        return self.terminal.busy and front is not None and not front.is_raw and front.receiver is None

    @property
    def cursor(self) -> tuple[int, int] | None:
        """Column and line of the cursor in the view; None while it is hidden or scrolled out of sight."""
        cursor = self.terminal.screen.cursor
        line = cursor.y + self.scroll
        if cursor.hidden or line >= self.lines:
            return None
        return min(cursor.x, self.columns - 1), line

    def stale(self) -> None:
        """Make the next `changes` return everything."""
        self._stale = True

    def row(self, line: int) -> Sequence[Char]:
        """The characters of a line of the view."""
        return self._rows[line] if line < len(self._rows) else ()

    def changes(self) -> set[int]:
        """Bring the screen up to date and return the lines of the view that differ from before."""
        changed = self.terminal.update()
        self.terminal.mark_seen()
        screen = self.terminal.screen
        # What was read between the frames counts too.
        dirty: Iterable[int] = changed | screen.dirty
        screen.dirty.clear()
        columns, lines = screen.columns, screen.lines
        if self.scroll:
            dirty = range(lines)
        else:
            self._top = None
        resized = len(self._rows) != lines or len(self._rows[0]) != columns
        self.passed = 0 if resized else screen.scrolled - self._scrolled
        self._scrolled = screen.scrolled
        cursor = self.cursor
        if self._stale or resized:
            self._rows = [self._read(line, columns) for line in range(lines)]
            self._cursor = cursor
            self._stale = False
            return set(range(lines))
        changes = set()
        for line in dirty:
            if line < lines and (new := self._read(line, columns)) != self._rows[line]:
                self._rows[line] = new
                changes.add(line)
        if cursor != self._cursor:
            changes |= {place[1] for place in (self._cursor, cursor) if place is not None}
            self._cursor = cursor
        return changes

    def _read(self, line: int, columns: int) -> list[Char]:
        return self._absolute_row(self.history - self.scroll + line, columns)

    def _absolute_row(self, index: int, columns: int) -> list[Char]:
        """The characters of a line counted from the beginning of the scrollback."""
        screen = self.terminal.screen
        if index < self.history:
            return _unfold(screen.history_row(index), columns, screen.blank)
        y = index - self.history
        if y not in screen.buffer:  # asking would make the line
            return [screen.blank] * columns
        row = screen.buffer[y]
        return list(map(row.get, range(columns), repeat(row.blank)))

    # -- scrolling -----------------------------------------------------------------------------------------------------

    def scroll_by(self, lines: int) -> bool:
        """Look back (positive) or forward; True if the view moved."""
        target = max(0, min(self.history, self.scroll + lines))
        moved = target != self.scroll
        self.scroll = target
        self._stale = self._stale or moved
        return moved

    def forget_history(self) -> None:
        """Forget what has scrolled away."""
        self.terminal.screen.scrollback.clear()
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
        attributes: Attributes | None = None
        plain: Style | None = None
        for x, char in enumerate(row):
            data = char.data
            if not data.isascii() or not data:
                data = _whole(row, x)
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
            text.append(data)
        if text:
            segments.append(Segment("".join(text), current))
        return segments

    def _marks(self, line: int, colours: Colours, focused: bool) -> dict[int, Style]:
        marks: dict[int, Style] = {}
        if self.selection is not None:
            (first_line, first), (last_line, last) = sorted(self.selection)
            absolute = self.history - self.scroll + line
            if first_line <= absolute <= last_line:
                start = first if absolute == first_line else 0
                end = last if absolute == last_line else self.columns
                marks = dict.fromkeys(range(start, end), colours.selection)
        cursor = self._cursor  # as of the rows, which another width may have left behind
        if cursor is not None and cursor[1] == line:
            style = _CURSOR_FOCUSED if focused else _CURSOR_AWAY
            base = _style(self.row(line)[cursor[0]][1:], colours)
            marks[cursor[0]] = base + style
        return marks

    def selected_text(self) -> str:
        """The selected text, lines without the blanks at their ends; one that was wrapped at the right edge is one line."""
        from day6_core.shell.screen.rows import Folded, cells_of

        if self.selection is None:
            return ""
        (first_line, first), (last_line, last) = sorted(self.selection)
        found = []
        for line in range(first_line, last_line + 1):
            row = self.line_row(line)
            start = first if line == first_line else 0
            text = "".join(cell.data for cell in cells_of(row)[start : last if line == last_line else None])
            goes_on = isinstance(row, Folded) and line != last_line
            found.append(text if goes_on else text.rstrip() + "\n")
        return "".join(found).removesuffix("\n")

    def whole_line(self, line: int) -> str:
        """The text of a line, counted from the beginning of the scrollback, with what was wrapped at the right edge."""
        from day6_core.shell.screen.rows import Folded, cells_of

        first = last = line
        while first > 0 and line - first < LONGEST_LINE and isinstance(self.line_row(first - 1), Folded):
            first -= 1
        bottom = self.history + self.lines - 1
        while last < bottom and last - line < LONGEST_LINE and isinstance(self.line_row(last), Folded):
            last += 1
        rows = (self.line_row(number) for number in range(first, last + 1))
        return "".join("".join(cell.data for cell in cells_of(row)) for row in rows)

    def line_row(self, line: int) -> Row:
        """A line counted from the beginning of the scrollback, as styled text."""
        screen, y = self.terminal.screen, line - self.history
        return screen.row(y) if y >= 0 else screen.history_row(line)


def _unfold(row: Row, columns: int, blank: Char) -> list[Char]:
    """A line of the scrollback (text, or runs of text and style) as characters, a wide one followed by an empty one."""
    from day6_core.shell.screen.rows import cells_of

    cells = cells_of(row)
    return cells[:columns] + [blank] * (columns - len(cells))


def _whole(row: Sequence[Char], x: int) -> str:
    """The character at a cell, a blank where only half of a wide one is left (the line must not change its width)."""
    data: str = row[x].data
    if data == "":
        return "" if x and cell_len(row[x - 1].data) == 2 else " "
    if cell_len(data) == 2 and (x + 1 >= len(row) or row[x + 1].data != ""):
        return " "
    return data


@lru_cache(maxsize=64)
def tab_name(command: str) -> str:
    """A short name for what runs: of `ros2 run turtlesim turtle_teleop_key` the executable, of `ros2 topic echo /x` 'echo /x'."""
    try:
        parts = shlex.split(command)
    except ValueError:  # a quotation that does not end
        parts = command.split()
    words = [word for word in parts if not word.startswith("-")]
    if words[:2] == ["ros2", "launch"] and len(words) > 2 and "." in words[2]:
        return words[2].rpartition("/")[2]
    if words and "/lib/" in words[0]:
        return words[0].rpartition("/")[2]  # an executable of a package by its path, as launch calls it
    if words[:2] in (["ros2", "run"], ["ros2", "launch"]) and len(words) > 3:
        return words[3]
    if words[:1] == ["ros2"] and len(words) > 2:
        return " ".join(words[2:4])
    if words[:1] in (["python3"], ["python"]) and len(words) > 1:
        return words[1].rpartition("/")[2]
    return command


_CURSOR_FOCUSED = Style(reverse=True)
_CURSOR_AWAY = Style(underline=True)
