"""What a VT100 keeps beside its text: the cursor, modes, margins, tab stops, and the pen's colours.

Sources: ECMA-48 for the control functions, the VT510 manual for DEC's modes, xterm's ctlseqs for what was added since.
"""

from __future__ import annotations

from copy import copy
from itertools import islice
from typing import NamedTuple

from day6_core.shell.screen.cells import BLANK, Char

IRM, LNM = 4, 20
"""Modes of ANSI: insert characters instead of replacing them, a new line begins at the left."""

DECSCNM, DECOM, DECAWM, DECTCEM, BRACKETED_PASTE = -5, -6, -7, -25, -2004
"""Private modes, as negative numbers: reverse video, rows count from the margin, autowrap, the cursor is shown."""

APPLICATION_CURSOR_KEYS = -1

LINE_DRAWING = str.maketrans("_`abcdefghijklmnopqrstuvwxyz{|}~+,-.0", "\xa0◆▒␉␌␍␊°±░␋┘┐┌└┼⎺⎻─⎼⎽├┤┴┬│≤≥π≠£·→←↑↓█")
"""What letters are in the character set `0`, with the arrows of the Linux console."""

MOST_ANSWERS = 100
"""Most replies to queries that wait to be delivered: a file full of queries needs no more."""

_NAMES = ("black", "red", "green", "brown", "blue", "magenta", "cyan", "white")
_COLOURS = {
    **{30 + n: ("fg", name) for n, name in enumerate(_NAMES)},
    **{40 + n: ("bg", name) for n, name in enumerate(_NAMES)},
    **{90 + n: ("fg", f"bright{name}") for n, name in enumerate(_NAMES)},
    **{100 + n: ("bg", f"bright{name}") for n, name in enumerate(_NAMES)},
    39: ("fg", "default"),
    49: ("bg", "default"),
}
_ATTRIBUTES = {
    1: ("bold", True), 3: ("italics", True), 4: ("underscore", True), 5: ("blink", True), 7: ("reverse", True),
    9: ("strikethrough", True), 22: ("bold", False), 23: ("italics", False), 24: ("underscore", False),
    25: ("blink", False), 27: ("reverse", False), 29: ("strikethrough", False),
}  # fmt: skip
_FIRST_16 = (
    "000000", "cd0000", "00cd00", "cdcd00", "0000ee", "cd00cd", "00cdcd", "e5e5e5",
    "7f7f7f", "ff0000", "00ff00", "ffff00", "5c5cff", "ff00ff", "00ffff", "ffffff",
)  # fmt: skip
_CUBE = (0x00, 0x5F, 0x87, 0xAF, 0xD7, 0xFF)


def colour_256(number: int) -> str:
    """The colour of xterm's table of 256: 16 named ones, a cube of 6 x 6 x 6, 24 greys."""
    if number < 16:
        return _FIRST_16[number]
    if number < 232:
        red, rest = divmod(number - 16, 36)
        return "".join(f"{_CUBE[part]:02x}" for part in (red, *divmod(rest, 6)))
    return f"{8 + 10 * (number - 232):02x}" * 3


def with_rendition(attrs: Char, blank: Char, numbers: list[int]) -> Char:
    """The pen after SGR; `blank` is the pen without any attribute."""
    changes: dict[str, str | bool] = {}
    rest = iter(numbers or [0])
    for number in rest:
        if number == 0:
            attrs, changes = blank, {}
        elif number in _COLOURS or number in _ATTRIBUTES:
            name, value = _COLOURS.get(number) or _ATTRIBUTES[number]
            changes[name] = value
        elif number in (38, 48):
            name, how = "fg" if number == 38 else "bg", next(rest, 0)
            wanted = list(islice(rest, {5: 1, 2: 3}.get(how, 0)))
            if how == 5 and wanted:
                changes[name] = colour_256(wanted[0])
            elif how == 2 and len(wanted) == 3:
                changes[name] = "".join(f"{part:02x}" for part in wanted)
    return attrs._replace(**changes)  # type: ignore[arg-type]


class Cursor:
    """Where the next character goes, counted from 0, and how it will look. In the last column `x` may be the width."""

    __slots__ = ("attrs", "hidden", "x", "y")

    def __init__(self, x: int = 0, y: int = 0, attrs: Char = BLANK) -> None:
        self.x, self.y, self.attrs = x, y, attrs
        self.hidden = False


class Margins(NamedTuple):
    """The rows between which text scrolls, both included."""

    top: int
    bottom: int


class SavedCursor(NamedTuple):
    """What DECSC saves."""

    cursor: Cursor
    line_drawing: bool
    origin: bool
    wrap: bool


class Vt:
    """The state of a terminal of `columns` x `lines` cells, without the text."""

    def __init__(self, columns: int, lines: int) -> None:
        self.columns, self.lines = columns, lines
        self.answers: list[str] = []
        """The terminal's replies to the program's queries, for `Terminal` to deliver."""
        self.dirty: set[int] = set()
        """Rows that look different from what was drawn of them."""
        self.title = ""
        self.cursor = Cursor()
        self.mode: set[int] = set()
        self.margins: Margins | None = None
        self.line_drawing = False
        """Whether letters are the line drawing characters of the VT100."""
        self.tabstops: set[int] = set()
        self.saved: SavedCursor | None = None
        self._reset_state()

    def _reset_state(self) -> None:
        self.title = ""
        self.mode = {DECAWM, DECTCEM}
        self.margins = None
        self.line_drawing = False
        self.tabstops = set(range(8, self.columns, 8))
        self.cursor = Cursor()
        self.dirty.update(range(self.lines))

    @property
    def blank(self) -> Char:
        """A cell that nothing was drawn in."""
        return BLANK._replace(reverse=True) if DECSCNM in self.mode else BLANK

    @property
    def rows_that_scroll(self) -> Margins:
        return self.margins or Margins(0, self.lines - 1)

    # -- the pen -------------------------------------------------------------------------------------------------------

    def define_charset(self, final: str) -> None:
        """SCS for G0: `0` are lines, `B` is ASCII; others change nothing."""
        if final in "0B":
            self.line_drawing = final == "0"

    def set_title(self, param: str) -> None:
        self.title = param

    # -- the cursor ----------------------------------------------------------------------------------------------------

    def place(self, x: int, y: int) -> None:
        """Move the cursor to a cell, or to the nearest one that there is."""
        self.cursor.x = min(max(0, x), self.columns - 1)
        self._to_row(y)

    def _to_row(self, y: int) -> None:
        top, bottom = self.rows_that_scroll if DECOM in self.mode else (0, self.lines - 1)
        self.cursor.y = min(max(top, y), bottom)

    def carriage_return(self) -> None:
        self.cursor.x = 0

    def backspace(self) -> None:
        self.cursor_back()

    def cursor_up(self, count: int = 0) -> None:
        """CUU: up to the top margin."""
        self.cursor.y = max(self.cursor.y - (count or 1), self.rows_that_scroll.top)

    def cursor_down(self, count: int = 0) -> None:
        """CUD, VPR: down to the bottom margin."""
        self.cursor.y = min(self.cursor.y + (count or 1), self.rows_that_scroll.bottom)

    def cursor_back(self, count: int = 0) -> None:
        """CUB."""
        self.cursor.x = max(0, min(self.cursor.x, self.columns - 1) - (count or 1))

    def cursor_forward(self, count: int = 0) -> None:
        """CUF, HPR."""
        self.cursor.x = min(self.cursor.x + (count or 1), self.columns - 1)

    def next_line(self, count: int = 0) -> None:
        """CNL."""
        self.cursor_down(count)
        self.cursor.x = 0

    def previous_line(self, count: int = 0) -> None:
        """CPL."""
        self.cursor_up(count)
        self.cursor.x = 0

    def cursor_position(self, line: int = 0, column: int = 0) -> None:
        """CUP, HVP: counted from 1. Where rows count from the margin, one beyond the margins changes nothing."""
        y = (line or 1) - 1
        if self.margins is not None and DECOM in self.mode:
            y += self.margins.top
            if y > self.margins.bottom:
                return
        self.place((column or 1) - 1, y)

    def cursor_to_column(self, column: int = 0) -> None:
        """CHA, HPA."""
        self.cursor.x = min((column or 1) - 1, self.columns - 1)

    def cursor_to_line(self, line: int = 0) -> None:
        """VPA."""
        self._to_row((line or 1) - 1 + (self.rows_that_scroll.top if DECOM in self.mode else 0))

    def save_cursor(self) -> None:
        """DECSC: one place, as xterm does."""
        self.saved = SavedCursor(copy(self.cursor), self.line_drawing, DECOM in self.mode, DECAWM in self.mode)

    def restore_cursor(self) -> None:
        """DECRC."""
        if self.saved is None:
            self.mode.discard(DECOM)
            self.place(0, 0)
            return
        self.line_drawing = self.saved.line_drawing
        self.mode |= {mode for mode, was in ((DECOM, self.saved.origin), (DECAWM, self.saved.wrap)) if was}
        self.cursor = copy(self.saved.cursor)
        top, bottom = self.rows_that_scroll
        self.cursor.x = min(self.cursor.x, self.columns - 1)
        self.cursor.y = min(max(top, self.cursor.y), bottom)

    # -- tab stops -----------------------------------------------------------------------------------------------------

    def tab(self) -> None:
        self.cursor.x = min((stop for stop in self.tabstops if stop > self.cursor.x), default=self.columns - 1)

    def tabs(self, count: int = 0) -> None:
        """CHT: go on by so many tab stops."""
        for _ in range(min(max(count, 1), self.columns)):
            self.tab()

    def back_tabs(self, count: int = 0) -> None:
        """CBT: go back by so many tab stops."""
        before = [0, *sorted(stop for stop in self.tabstops if stop < self.cursor.x)]
        self.cursor.x = before[-min(max(count, 1), len(before))]

    def set_tab_stop(self) -> None:
        """HTS."""
        self.tabstops.add(self.cursor.x)

    def clear_tab_stop(self, how: int = 0) -> None:
        """TBC: the one at the cursor (0), or all (3)."""
        if how == 0:
            self.tabstops.discard(self.cursor.x)
        elif how == 3:
            self.tabstops.clear()

    # -- modes and margins ---------------------------------------------------------------------------------------------

    def set_margins(self, top: int = 0, bottom: int = 0) -> None:
        """DECSTBM: rows counted from 1, 0 for the edge of the screen; fewer than two rows change nothing."""
        last = self.lines - 1
        rows = Margins(min(max(top, 1) - 1, last), min((bottom or self.lines) - 1, last))
        if rows == (0, last) and not top > 1 and not bottom:
            self.margins = None
        elif rows.bottom > rows.top:
            self.margins = rows
            self.cursor_position()

    def change_modes(self, numbers: set[int], *, on: bool) -> None:
        """SM and RM; private ones are negative."""
        self.mode = self.mode | numbers if on else self.mode - numbers
        if DECOM in numbers:
            self.cursor_position()
        if DECTCEM in numbers:
            self.cursor.hidden = not on

    # -- answers -------------------------------------------------------------------------------------------------------

    def answer(self, text: str) -> None:
        """Reply to a query."""
        if len(self.answers) < MOST_ANSWERS:
            self.answers.append(text)

    def report_device_attributes(self, mode: int = 0) -> None:
        """DA: a VT102."""
        if mode == 0:
            self.answer("\x1b[?6c")

    def report_device_status(self, what: int = 0) -> None:
        """DSR: all is well (5), where the cursor is (6)."""
        if what == 5:
            self.answer("\x1b[0n")
        elif what == 6:
            top = self.rows_that_scroll.top if DECOM in self.mode else 0
            self.answer(f"\x1b[{self.cursor.y + 1 - top};{self.cursor.x + 1}R")
