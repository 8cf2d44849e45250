"""The picture of a terminal: what programs write becomes text on a screen, as xterm shows it.

Only the thread that draws touches a screen; `Terminal.update` feeds it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from day6_core.session.harmless import for_emulation
from day6_core.shell.screen.cells import Char, Line
from day6_core.shell.screen.rows import (
    PLAIN_STYLE,
    Row,
    Style,
    cell_texts,
    combined,
    fit,
    folded,
    in_style,
)
from day6_core.shell.screen.running_text import RunningText
from day6_core.shell.screen.sequences import NEVER, SequenceParser, colour_numbers
from day6_core.shell.screen.size import SizedText
from day6_core.shell.screen.text import MOST_ARRIVING, fill_cells
from day6_core.shell.screen.vt import (
    APPLICATION_CURSOR_KEYS,
    BRACKETED_PASTE,
    DECAWM,
    DECSCNM,
    IRM,
    LINE_DRAWING,
    LNM,
    Cursor,
    with_rendition,
)
from day6_core.shell.screen.whole_lines import NOT_NARROW, WholeLines
from day6_core.width import char_width, fitting, widths

_ALTERNATE_MODES = {-47, -1047, -1049}
_CONTROLS = {
    "\b": "backspace",
    "\t": "tab",
    "\n": "linefeed",
    "\x0b": "linefeed",
    "\x0c": "linefeed",
    "\r": "carriage_return",
    "\r\n": "new_line",
    "\x84": "index",
    "\x85": "new_line",
    "\x88": "set_tab_stop",
    "\x8d": "reverse_index",
}
_ESCAPES = {
    ("", "c"): "reset",
    ("", "D"): "index",
    ("", "E"): "new_line",
    ("", "M"): "reverse_index",
    ("", "H"): "set_tab_stop",
    ("", "7"): "save_cursor",
    ("", "8"): "restore_cursor",
    ("#", "8"): "alignment_display",
}
_SEQUENCES = {
    "@": ("insert_characters", 1),
    "A": ("cursor_up", 1),
    "B": ("cursor_down", 1),
    "C": ("cursor_forward", 1),
    "D": ("cursor_back", 1),
    "E": ("next_line", 1),
    "F": ("previous_line", 1),
    "G": ("cursor_to_column", 1),
    "H": ("cursor_position", 2),
    "I": ("tabs", 1),
    "J": ("erase_in_display", 1),
    "K": ("erase_in_line", 1),
    "L": ("insert_lines", 1),
    "M": ("delete_lines", 1),
    "P": ("delete_characters", 1),
    "S": ("scroll_up", 1),
    "T": ("scroll_down", 1),
    "X": ("erase_characters", 1),
    "Z": ("back_tabs", 1),
    "`": ("cursor_to_column", 1),
    "a": ("cursor_forward", 1),
    "b": ("repeat", 1),
    "c": ("report_device_attributes", 1),
    "d": ("cursor_to_line", 1),
    "e": ("cursor_down", 1),
    "f": ("cursor_position", 2),
    "g": ("clear_tab_stop", 1),
    "n": ("report_device_status", 1),
    "r": ("set_margins", 2),
    "s": ("save_cursor", 0),
    "u": ("restore_cursor", 0),
}
"""What a control sequence does, by its final character, and how many parameters it has; more are ignored."""


class _MainScreen(NamedTuple):
    """What a full-screen program leaves alone: the lines of the screen, their size, the cursor."""

    lines: dict[int, Line]
    size: tuple[int, int]
    cursor: Cursor


class Screen(SizedText):
    """A terminal's screen of `columns` x `lines` cells with its scrollback above it."""

    def __init__(self, columns: int, lines: int) -> None:
        super().__init__(columns, lines)
        self._last_drawn = ""
        """What REP repeats."""
        self._main: _MainScreen | None = None
        self._whole_lines = WholeLines(self)
        self._running_text = RunningText(self)
        self._style_of: Char | None = None
        self._style_now = PLAIN_STYLE
        self._colours: dict[tuple[Char, str], Char] = {}
        self._parser = SequenceParser(self)

    # -- what the view reads -------------------------------------------------------------------------------------------

    @property
    def bracketed_paste(self) -> bool:
        return BRACKETED_PASTE in self.mode

    @property
    def application_cursor_keys(self) -> bool:
        """Whether the arrow keys are to be sent as ESC O A instead of ESC [ A."""
        return APPLICATION_CURSOR_KEYS in self.mode

    @property
    def alternate(self) -> bool:
        """Whether a full-screen program has the screen (no scrollback then)."""
        return self._main is not None

    # -- feeding -------------------------------------------------------------------------------------------------------

    def feed(self, text: str, until: float = NEVER) -> str:
        """Show what a program wrote, or as much as fits before `until` (perf_counter); return the rest."""
        text = for_emulation(text)
        self._whole_lines.begin()
        rest = self._parser.feed(text, until)
        if self._arriving:
            self.dirty.update(range(self.lines))
            if len(self._arriving) > MOST_ARRIVING:
                self._make_room()
        return rest

    def control(self, char: str) -> None:
        getattr(self, _CONTROLS[char])()

    def escape(self, parts: str, final: str) -> None:
        if parts == "(":
            self.define_charset(final)
        elif (name := _ESCAPES.get((parts, final))) is not None:
            getattr(self, name)()

    def sequence(self, private: str, parameters: list[int], final: str) -> None:
        if final in "hl" and private in ("", "?"):
            self.change_modes({-number if private else number for number in parameters}, on=final == "h")
        elif final in _SEQUENCES and (not private or (private == "?" and final in "JK")):
            name, most = _SEQUENCES[final]
            getattr(self, name)(*parameters[:most])

    def colour(self, parameters: str) -> None:
        before = self.cursor.attrs
        after = self._colours.get((before, parameters))
        if after is None:
            after = with_rendition(before, self.blank, colour_numbers(parameters))
            if len(self._colours) > 1024:
                self._colours.clear()
            self._colours[before, parameters] = after
        self.cursor.attrs = after

    def rush(self, text: str, start: int) -> int:
        at = self._whole_lines.take(text, start)
        return self._running_text.take(text, at, self._whole_lines.odd_before)

    def ran(self, rows: Sequence[Row], drawn: str) -> None:
        """Text has run through the last line: into these rows above it, last of all `drawn`."""
        self.arrive(rows)
        self.dirty.add(self.lines - 1)
        if drawn:
            self._last_drawn = drawn[-1]

    def is_simple(self) -> bool:
        """Whether text goes from cell to cell and on to the next line, as it nearly always does."""
        mode = self.mode
        return IRM not in mode and DECAWM in mode and not self.margins and not self.line_drawing

    def style(self) -> Style:
        attrs = self.cursor.attrs
        if attrs is not self._style_of:
            self._style_of = attrs
            self._style_now = Style(*attrs[1:])
        return self._style_now

    # -- drawing -------------------------------------------------------------------------------------------------------

    def draw(self, data: str) -> None:
        self._last_drawn = data[-1:]
        if self.line_drawing:
            data = data.translate(LINE_DRAWING)
        if IRM in self.mode or DECAWM not in self.mode or self.columns < 2:
            self._draw_slowly(data)
            return
        digits = "" if data.isascii() or not NOT_NARROW.search(data) else widths(data)
        if "0" in digits:
            self._draw_with_marks(data, digits)
        else:
            self._flow(data, digits if "2" in digits else "")

    def _draw_with_marks(self, data: str, digits: str) -> None:
        """Text with characters that take no cell, which go onto the one before."""
        for found in re.finditer("(0+)|[12]+", digits):
            start, end = found.span()
            if found[1]:
                for char in data[start:end]:
                    self._combine(char)
            else:
                self._flow(data[start:end], digits[start:end])

    def _flow(self, data: str, digits: str) -> None:
        """Draw text of which every character takes a cell or two (`digits` are the widths, '' says one each), with autowrap."""
        cursor = self.cursor
        columns = self.columns
        end = len(data)
        room = columns - cursor.x
        if end <= room and not digits:
            self._put(data, digits)
            return
        start = fitting(digits, 0, room) if digits else min(room, end)
        if start:
            self._put(data[:start], digits[:start])
        while start < end:
            self._wrap()
            if end - start > columns and self.is_at_the_empty_end():
                rows = folded(data[start:], columns)
                start = end - len(rows.pop())
                self.arrive(in_style(rows, self.style()))
            count = fitting(digits, start, columns) if digits else min(columns, end - start)
            self._put(data[start : start + count], digits[start : start + count])
            start += count

    def _wrap(self) -> None:
        """Go on in the next line with the text that has come to the right edge."""
        cursor, x = self.cursor, self.cursor.x
        self.dirty.add(cursor.y)
        cursor.x = 0
        if self.pen and cursor.y == self.lines - 1 and self.margins is None:
            self._arriving.append(self.pen.fold(x))
            return
        line = self.line()
        if line.get(x) == self.blank:
            del line[x]
        if x:  # cells that the cursor skipped are blanks of the line that goes on
            line.setdefault(x - 1, self.blank)
        line.folded = True
        self.linefeed()
        line.folded = self._buffer.get(cursor.y) is not line  # below the margins there is no next line

    def _put(self, text: str, digits: str) -> None:
        """Draw text that fits into the rest of the line."""
        cursor = self.cursor
        x = cursor.x
        end = x + len(text) + digits.count("2")
        self.dirty.add(cursor.y)
        if self.pen_is_at_hand():
            self.pen.put(x, "".join(cell_texts(text, digits)))
            cursor.x = end
            return
        line = self.line()
        if x in line or end in line:
            self._clear_halves(line, x, end - x)
        fill_cells(line, x, text, digits, self.cells_in(cursor.attrs))
        cursor.x = end

    def pen_is_at_hand(self) -> bool:
        """Whether the last line is plain text, and what comes is too."""
        if self.cursor.y != self.lines - 1 or DECSCNM in self.mode or self.style() != PLAIN_STYLE:
            return False
        return bool(self.pen) or not self._buffer.get(self.lines - 1)

    def _draw_slowly(self, data: str) -> None:
        """Character by character: insert mode, no autowrap."""
        cursor = self.cursor
        for char in data:
            width = char_width(char)
            if width == 0:
                self._combine(char)
                continue
            if cursor.x + width > self.columns:
                if DECAWM in self.mode:
                    self._wrap()
                else:
                    cursor.x = max(self.columns - width, 0)
            if IRM in self.mode:
                self.insert_characters(width)
            line = self.buffer[cursor.y]
            cells = self.cells_in(cursor.attrs)
            self._clear_halves(line, cursor.x, width)
            line[cursor.x] = cells[char]
            if width == 2 and cursor.x + 1 < self.columns:
                line[cursor.x + 1] = cells[""]
            cursor.x = min(cursor.x + width, self.columns)
        self.dirty.add(cursor.y)

    def _clear_halves(self, line: Line, x: int, width: int) -> None:
        """Overwriting one half of a wide character removes the other half."""
        if x and x in line and line[x].data == "":
            line[x - 1] = self.blank
        end = x + width
        if end in line and line[end].data == "":
            line[end] = self.blank

    def _combine(self, char: str) -> None:
        if not self.cursor.x:
            return
        self.dirty.add(self.cursor.y)
        if self.pen and self.cursor.y == self.lines - 1:
            self.pen.mark(self.cursor.x, char)
            return
        x = self.cursor.x - 1
        line = self.line()
        if line[x].data == "" and x:
            x -= 1
        line[x] = combined(line[x], char)

    # -- inserting and erasing -----------------------------------------------------------------------------------------

    def insert_characters(self, count: int = 0) -> None:
        """ICH: what stands at the cursor and behind it moves to the right."""
        line, x, count = self.line(), self.cursor.x, count or 1
        self._clear_halves(line, x, 0)
        line_cells = {at + count: line[at] for at in line if at >= x}
        for at in [at for at in line if at >= x]:
            del line[at]
        line.update(line_cells)
        fit(line, self.columns)
        if line.folded:
            line.setdefault(self.columns - 1, self.blank)
        self.dirty.add(self.cursor.y)

    def delete_characters(self, count: int = 0) -> None:
        """DCH: what stands behind the deleted cells moves to the left."""
        line, x, count = self.line(), self.cursor.x, count or 1
        moved = {at - count: line[at] for at in line if at >= x + count}
        for at in [at for at in line if at >= x]:
            del line[at]
        line.update(moved)
        fit(line, self.columns)
        line.folded = False
        self.dirty.add(self.cursor.y)

    def erase_characters(self, count: int = 0) -> None:
        """ECH."""
        self._erase(self.cursor.x, min(self.cursor.x + (count or 1), self.columns))

    def erase_in_line(self, how: int = 0) -> None:
        """EL: from the cursor on (0), up to it (1), all (2)."""
        x = self.cursor.x
        if how <= 2:
            self._erase(*((x, self.columns), (0, min(x + 1, self.columns)), (0, self.columns))[how])

    def _erase(self, first: int, end: int) -> None:
        """Erase cells of the line with the cursor."""
        line = self.line()
        self._clear_halves(line, first, end - first)
        line.update(dict.fromkeys(range(first, end), self._erased()))
        self.dirty.add(self.cursor.y)
        if end == self.columns:
            line.folded = False
            if not first:
                self.cut(self.cursor.y)

    def _erased(self) -> Char:
        """An erased cell: of the pen's attributes it takes the background alone (terminfo's bce)."""
        background = self.cursor.attrs.bg
        return self.blank if background == "default" else self.blank._replace(bg=background)

    def erase_in_display(self, how: int = 0) -> None:
        """ED: from the cursor on (0), up to it (1), the screen (2), the scrollback (3)."""
        if how > 3:
            return
        if how == 3:
            self.scrollback.clear()
            self.dirty.update(range(self.lines))
            return
        if not self.alternate and how != 1:
            self._below = []
        y, erased = self.cursor.y, self._erased()
        rows = (range(y + 1, self.lines), range(y), range(self.lines))[how]
        lines = self.buffer
        for each in rows:
            lines.pop(each, None)
            if erased != self.blank:
                lines[each].update(dict.fromkeys(range(self.columns), erased))
        self.dirty.update(rows)
        if 0 in rows:
            self.cut(0)
        if how != 2:
            self.erase_in_line(how)
        elif not self.alternate:
            self._cleared = self._scrolled

    def alignment_display(self) -> None:
        """DECALN."""
        line = dict.fromkeys(range(self.columns), self.blank._replace(data="E"))
        for y in range(self.lines):
            self.buffer[y].update(line)
        self.dirty.update(range(self.lines))

    # -- scrolling -----------------------------------------------------------------------------------------------------

    def index(self) -> None:
        """IND: down a line; at the bottom margin the text scrolls."""
        top, bottom = self.rows_that_scroll
        if self.cursor.y != bottom:
            self.cursor_down()
        elif self.margins is None:
            self.push_up()
        else:
            self._move_rows(top, bottom, -1)

    def reverse_index(self) -> None:
        """RI: up a line; at the top margin the text scrolls."""
        top, bottom = self.rows_that_scroll
        if self.cursor.y != top:
            self.cursor_up()
        else:
            self._move_rows(top, bottom, 1)

    def linefeed(self) -> None:
        self.index()
        if LNM in self.mode:
            self.cursor.x = 0

    def new_line(self) -> None:
        """NEL."""
        self.cursor.x = 0
        self.index()

    def insert_lines(self, count: int = 0) -> None:
        """IL: between the margins only."""
        top, bottom = self.rows_that_scroll
        if top <= self.cursor.y <= bottom:
            self._move_rows(self.cursor.y, bottom, count or 1)
            self.cursor.x = 0

    def delete_lines(self, count: int = 0) -> None:
        """DL: between the margins only."""
        top, bottom = self.rows_that_scroll
        if top <= self.cursor.y <= bottom:
            self._move_rows(self.cursor.y, bottom, -(count or 1))
            self.cursor.x = 0

    def scroll_up(self, count: int = 0) -> None:
        """SU: the lines between the margins move up, and the cursor stays where it is."""
        y = self.cursor.y
        self.cursor.y = self.rows_that_scroll.bottom
        for _ in range(min(max(count, 1), self.lines)):
            self.index()
        self.cursor.y = y

    def scroll_down(self, count: int = 0) -> None:
        """SD: the lines between the margins move down."""
        self._move_rows(*self.rows_that_scroll, max(count, 1))

    def _move_rows(self, first: int, last: int, by: int) -> None:
        """Move rows up (negative) or down; what leaves `first` to `last` is lost, what is free then is empty."""
        self.cut(last + 1)
        buffer = self.buffer
        rows = range(first, last + 1)
        moved = {y + by: line for y in rows if (line := buffer.pop(y, None)) is not None and y + by in rows}
        buffer.update(moved)
        self.cut(first)
        self.cut(last + 1)
        self.dirty.update(rows)

    def repeat(self, count: int = 0) -> None:
        """REP: draw the last character again."""
        if self._last_drawn:
            self.draw(self._last_drawn * min(max(count, 1), self.columns * self.lines))

    # -- modes ---------------------------------------------------------------------------------------------------------

    def change_modes(self, numbers: set[int], *, on: bool) -> None:
        if numbers & _ALTERNATE_MODES and on != self.alternate:
            self._enter_alternate() if on else self._leave_alternate()
        super().change_modes(numbers - _ALTERNATE_MODES, on=on)
        if DECSCNM in numbers:
            self._turn_over(on)

    def _turn_over(self, on: bool) -> None:
        """DECSCNM: all cells are reversed, or none."""
        self._colours.clear()
        self.buffer.blank = self.blank
        for line in self.buffer.values():
            line.blank = self.blank
            line.update({x: cell._replace(reverse=on) for x, cell in line.items()})
        self.cursor.attrs = self.cursor.attrs._replace(reverse=on)
        self.dirty.update(range(self.lines))

    def _enter_alternate(self) -> None:
        cursor = Cursor(self.cursor.x, self.cursor.y, self.cursor.attrs)
        self._main = _MainScreen(dict(self.buffer), (self.lines, self.columns), cursor)
        self.keeps_history = False
        self.buffer.clear()
        self.dirty.update(range(self.lines))

    def _leave_alternate(self) -> None:
        """Show the main screen again, in the size that the window has now."""
        main, self._main = self._main, None
        assert main is not None
        size = self.lines, self.columns
        self.buffer.clear()
        self.keeps_history = True
        self.buffer.update(main.lines)
        self.lines, self.columns = main.size
        self.cursor.x, self.cursor.y = main.cursor.x, main.cursor.y
        self.cursor.attrs = self.blank
        self.margins = None
        self.resize(*size)
        self.dirty.update(range(self.lines))

    def reset(self) -> None:
        """RIS."""
        self._settle()
        self._main, self.keeps_history = None, True
        self._below = []
        self.cut(0)
        self._cleared = self._scrolled
        self._buffer.clear()
        self._reset_state()
        self._buffer.blank = self.blank
