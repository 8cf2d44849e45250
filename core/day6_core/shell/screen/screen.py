"""The picture of a terminal: pyte's VT emulation with scrollback, alternate screen, right widths, and fast ways for floods.

Only the thread that draws touches a screen; `Terminal.update` feeds it.

Scrolling text costs little, because a line that leaves the screen is never drawn cell by cell: while the cursor is in
the last line, whole lines of text become rows at once (`WholeLines`), long ones are folded into rows (`_flow`), and the rows
only queue up below the screen (`_arriving`). Reading `buffer` or `scrollback` first moves them in (`_settle`).

A row that goes on in the next one is marked (`Folded`, `Line.folded`), so that another width folds the text anew (`reflow`).
"""

from __future__ import annotations

import copy
import re
from collections import defaultdict, deque
from collections.abc import Sequence
from typing import NamedTuple
from weakref import WeakSet

from day6_core.session.harmless import for_emulation
from day6_core.shell.screen.light_pyte import Char, Cursor, Line, charsets, modes
from day6_core.shell.screen.light_pyte import Screen as PyteScreen
from day6_core.shell.screen.light_pyte import Stream as PyteStream
from day6_core.shell.screen.reflow import Marker, rewrap
from day6_core.shell.screen.rows import (
    PLAIN_STYLE,
    Folded,
    FoldedText,
    Row,
    Style,
    as_row,
    cells_of,
    combined,
    ended,
    fit,
    folded,
    in_style,
    row_text,
    runs_of,
    with_mark,
    without_end,
)
from day6_core.shell.screen.sequences import NEVER, Parser, colour_numbers
from day6_core.shell.screen.whole_lines import NOT_NARROW, WholeLines
from day6_core.width import char_width, fitting, widths

SCROLLBACK = 5000
"""Lines kept above the screen, while it is as wide as it ever was; a narrower one needs more for the same text."""

MOST_ANSWERS = 100
"""Most replies to queries that wait to be delivered: a file full of queries needs no more."""

MOST_ARRIVING = 512
"""Rows that queue up below the screen after a text was fed."""

ALTERNATE_MODES = frozenset({47, 1047, 1049})
BRACKETED_PASTE = 2004 << 5
APPLICATION_CURSOR_KEYS = 1 << 5

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
_ESCAPES = {("", final): name for final, name in {**PyteStream.escape, "E": "new_line"}.items()}
_ESCAPES["#", "8"] = "alignment_display"
_SEQUENCES = {final: name for final, name in PyteStream.csi.items() if name != "select_graphic_rendition"}
_SEQUENCES |= {
    "b": "repeat",
    "S": "scroll_up",
    "T": "scroll_down",
    "I": "tabs",
    "Z": "back_tabs",
    "`": "cursor_to_column",
}
_SEQUENCES |= {"s": "save_place", "u": "restore_place"}
"""Sequences that ncurses uses as soon as TERM is xterm (`infocmp xterm-256color`: rep, indn, rin, cbt) and pyte lacks."""
_PRIVATE_SEQUENCES = {"h": "set_mode", "l": "reset_mode", "J": "erase_in_display", "K": "erase_in_line"}


class _Cells(dict[str, Char]):
    """The characters of one style, each made once."""

    def __init__(self, attrs: Char) -> None:
        self._attrs = attrs

    def __missing__(self, data: str) -> Char:
        if len(self) > 4096:
            self.clear()
        cell: Char = self._attrs._replace(data=data)
        self[data] = cell
        return cell


class _MainScreen(NamedTuple):
    """What a full-screen program leaves alone: the lines of the screen, their size, the cursor."""

    buffer: dict[int, Line]
    size: tuple[int, int]
    cursor: Cursor


class Screen(PyteScreen):
    """A VT100 screen of `columns` x `lines` cells with `scrollback` above it."""

    def __init__(self, columns: int, lines: int) -> None:
        self._scrollback: deque[Row] = deque(maxlen=SCROLLBACK)
        self._scrolled = 0
        self._cleared = 0
        """`scrolled` when the screen was last cleared: growing brings back no line from before."""
        self._widest = columns
        self._below: list[Row] = []
        """The last line, and those under it that a lower window has no room for because its cursor stands so high."""
        self._below_since = 0
        """`scrolled` when they were there: any line that scrolls forgets them."""
        self.markers: WeakSet[Marker] = WeakSet()
        """Places that follow their text when it is wrapped anew."""
        self._arriving: list[Row | Line | None] = []
        """Rows above the one with the cursor that have not moved into the screen yet: rows, or lines of pyte's buffer."""
        self._pen: list[str] = []
        """What was drawn in the last line so far, cell by cell, while it is plain text: it is no line of pyte's buffer yet."""
        self._last_drawn = ""
        """What REP repeats."""
        self._passed = 0
        """Rows that went by and are not even kept in the scrollback."""
        self._whole_lines = WholeLines(self)
        self._style_of: Char | None = None
        self._style_now = PLAIN_STYLE
        self.answers: list[str] = []
        """The terminal's replies to the program's queries, for `Terminal` to deliver."""
        self._cells: dict[tuple[object, ...], _Cells] = {}
        self._colours: dict[tuple[Char, str], Char] = {}
        self._main: _MainScreen | None = None
        super().__init__(columns, lines)
        self._buffer: dict[int, Line] = defaultdict(lambda: Line(self.default_char))
        self._parser = Parser(self)

    # -- what the view reads -------------------------------------------------------------------------------------------

    @property  # type: ignore[override]  # Line is pyte's own, and a mark
    def buffer(self) -> dict[int, Line]:
        """pyte's lines of cells, by their number."""
        if self._arriving or self._pen:
            self._settle()
        return self._buffer

    @buffer.setter
    def buffer(self, lines: dict[int, Line]) -> None:
        self._buffer = lines

    @property
    def scrollback(self) -> deque[Row]:
        """The lines above the screen, the oldest first."""
        if self._arriving:
            self._settle()
        return self._scrollback

    @property
    def scrolled(self) -> int:
        """Lines that ever left the screen at the top; a view that is scrolled back uses it to stay where it is."""
        if self._arriving:
            self._settle()
        return self._scrolled

    def row(self, y: int) -> Row:
        """Line `y` of the screen, 0 at the top."""
        return _row_of(self.buffer.get(y))

    def history_row(self, index: int) -> Row:
        """Line `index` of the scrollback, 0 the oldest."""
        return self.scrollback[index]

    @property
    def text(self) -> str:
        """The screen as plain lines without blanks at their ends."""
        return "\n".join(row_text(self.row(y)).rstrip(" ") for y in range(self.lines)).rstrip()

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

    def feed(self, text: str, until: float = NEVER) -> int:
        """Show what a program wrote, or as much as fits before `until` (perf_counter); return how much."""
        text = for_emulation(text)
        self._whole_lines.begin()
        read = self._parser.feed(text, until)
        if self._arriving:
            self.dirty.update(range(self.lines))
            if len(self._arriving) > MOST_ARRIVING:
                self._settle()
        return read

    def control(self, char: str) -> None:
        getattr(self, _CONTROLS[char])()

    def new_line(self) -> None:
        self.cursor.x = 0
        self.index()

    def escape(self, parts: str, final: str) -> None:
        name = _ESCAPES.get((parts, final))
        if parts in ("(", ")"):
            self.define_charset(final, parts)
        elif name is not None:
            getattr(self, name)()

    def sequence(self, private: str, parameters: list[int], final: str) -> None:
        if private == "?":
            name = _PRIVATE_SEQUENCES.get(final)
        else:
            name = None if private else _SEQUENCES.get(final)
        if name is None:
            return
        try:
            if private:
                getattr(self, name)(*parameters, private=True)
            else:
                getattr(self, name)(*parameters)
        except (TypeError, ValueError, LookupError, NameError, AttributeError, AssertionError):
            return  # parameters that pyte cannot handle

    def colour(self, parameters: str) -> None:
        before = self.cursor.attrs
        after = self._colours.get((before, parameters))
        if after is None:
            self.select_graphic_rendition(*colour_numbers(parameters))
            after = self.cursor.attrs
            if after.bg == "bfightmagenta":  # pyte's typo
                after = after._replace(bg="brightmagenta")
            if len(self._colours) > 1024:
                self._colours.clear()
            self._colours[before, parameters] = after
        self.cursor.attrs = after

    def rush(self, text: str, start: int) -> int:
        return self._whole_lines.take(text, start)

    # -- what scrolls in ---------------------------------------------------------------------------------------------------

    def is_simple(self) -> bool:
        """Whether text goes from cell to cell and on to the next line, as it nearly always does."""
        mode = self.mode
        return (
            modes.IRM not in mode and modes.DECAWM in mode and not self.margins and self.g0_charset is charsets.LAT1_MAP
        )

    def style(self) -> Style:
        attrs = self.cursor.attrs
        if attrs is not self._style_of:
            self._style_of = attrs
            self._style_now = Style(*attrs[1:])
        return self._style_now

    def arrive(self, rows: Sequence[Row]) -> None:
        """Rows that scroll in from below, above the line with the cursor."""
        surplus = len(rows) - (self._scrollback.maxlen or 0) - self.lines
        if surplus > 0:
            self._settle()
            self._passed += surplus
        self._arriving += rows[surplus:] if surplus > 0 else rows

    def _settle(self) -> None:
        """Let the rows that queued up below move into the screen, and what they push out into the scrollback."""
        if self._pen:
            self._lay_pen_down()
        if not self._arriving and not self._passed:
            return
        arriving, self._arriving = self._arriving, []
        passed, self._passed = self._passed, 0
        buffer, bottom = self._buffer, self.lines - 1
        current = buffer.pop(bottom, None)
        above = [buffer.pop(y, None) for y in range(bottom)]
        if passed:  # between what was here and what arrives
            self._remember_all(above)
            self._scrolled += passed
            above = []
        rows = above + arriving
        kept = rows[len(rows) - bottom :] if bottom else []
        self._remember_all(rows[: len(rows) - len(kept)])
        for y, row in enumerate(kept, bottom - len(kept)):
            if isinstance(row, dict):
                buffer[y] = row
            elif row:
                self._fill(buffer[y], row)
        if current is not None:
            buffer[bottom] = current
        self.dirty.update(range(self.lines))

    def _fill(self, line: Line, row: Row) -> None:
        """Make the cells of a row."""
        line.folded = isinstance(row, Folded)
        x = 0
        for text, style in runs_of(row):
            digits = "" if text.isascii() else widths(text)
            if "0" in digits:
                line.update(enumerate(cells_of(row)))
                return
            x = _fill(line, x, text, digits, self._cells_for(Char(" ", *style)))

    def _remember_all(self, rows: Sequence[Row | Line | None]) -> None:
        if self.alternate:
            return
        self._scrolled += len(rows)
        self._scrollback.extend(
            "" if not row else _row_of(row) if isinstance(row, dict) else without_end(row)
            for row in rows[-(self._scrollback.maxlen or 0) :]
        )

    # -- drawing -------------------------------------------------------------------------------------------------------

    def draw(self, data: str) -> None:
        self._last_drawn = data[-1:]
        if self.g0_charset is not charsets.LAT1_MAP:
            data = data.translate(self.g0_charset)
        if modes.IRM in self.mode or modes.DECAWM not in self.mode or self.columns < 2:
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
        if self._pen and cursor.y == self.lines - 1 and self.margins is None:
            if self._pen[x:] == [" "]:  # no room for a wide character: nothing stands there
                del self._pen[x:]
            skipped = " " * (x - len(self._pen))
            self._pen, text = [], "".join(self._pen)
            self._arriving.append(FoldedText(text + skipped))
            return
        line = self._line()
        if line.get(x) == self.default_char:
            del line[x]
        if x:  # cells that the cursor skipped are blanks of the line that goes on
            line.setdefault(x - 1, self.default_char)
        line.folded = True
        self.linefeed()
        line.folded = self._buffer.get(cursor.y) is not line  # below the margins there is no next line

    def _cut(self, y: int) -> None:
        """Line `y` is no longer what the line above it goes on with."""
        if y == self.lines - 1 and self._arriving:
            last = self._arriving[-1]
            if isinstance(last, Line):
                last.folded = False
            elif last is not None:
                self._arriving[-1] = ended(last)
        elif y:
            above = self.buffer.get(y - 1)
            if above is not None:
                above.folded = False
        elif not self.alternate and self.scrollback:
            self._scrollback[-1] = ended(self._scrollback[-1])

    def goes_on(self) -> bool:
        """Whether the last line is what the one above it goes on with: erasing it says something about that one, too."""
        if self._arriving:
            last = self._arriving[-1]
            return last.folded if isinstance(last, Line) else isinstance(last, Folded)
        if self.lines > 1:
            above = self._buffer.get(self.lines - 2)
            return above is not None and above.folded
        return bool(self.scrollback) and isinstance(self._scrollback[-1], Folded)

    def is_at_the_empty_end(self) -> bool:
        """Whether the cursor stands in a last line that nothing was drawn in, so that rows can arrive above it."""
        bottom = self.lines - 1
        return self.cursor.y == bottom and not self._pen and not self._buffer.get(bottom) and not self.margins

    def _put(self, text: str, digits: str) -> None:
        """Draw text that fits into the rest of the line."""
        cursor = self.cursor
        x = cursor.x
        if self._pen_is_at_hand():
            self._write(text, digits)
            return
        line = self._line()
        end = x + len(text) + digits.count("2")
        if x in line or end in line:
            self._clear_halves(line, x, end - x)
        _fill(line, x, text, digits, self._cells_for(cursor.attrs))
        cursor.x = end
        self.dirty.add(cursor.y)

    def _pen_is_at_hand(self) -> bool:
        """Whether the last line is plain text, and what comes is too."""
        if self.cursor.y != self.lines - 1 or modes.DECSCNM in self.mode or self.style() != PLAIN_STYLE:
            return False
        return bool(self._pen) or not self._buffer.get(self.lines - 1)

    def _write(self, text: str, digits: str) -> None:
        """Draw plain text into the last line."""
        pen, cursor = self._pen, self.cursor
        x, used = cursor.x, len(self._pen)
        cells = _with_second_halves(text, digits) if "2" in digits else text
        end = x + len(cells)
        if x > used:
            pen += " " * (x - used)
        elif x < used:
            if x and pen[x] == "":
                pen[x - 1] = " "
            if end < used and pen[end] == "":
                pen[end] = " "
        pen[x:end] = cells
        cursor.x = end
        self.dirty.add(cursor.y)

    def _lay_pen_down(self) -> None:
        """Turn the last line into an ordinary one."""
        pen, self._pen = self._pen, []
        cells = self._cells_for(Char(" ", *PLAIN_STYLE))
        self._buffer[self.lines - 1].update(enumerate(map(cells.__getitem__, pen)))

    def _line(self) -> Line:
        """The line with the cursor: the last of the screen stands still, whatever arrives above it."""
        y = self.cursor.y
        if y != self.lines - 1:
            return self.buffer[y]
        if self._pen:
            self._lay_pen_down()
        return self._buffer[y]

    def _draw_slowly(self, data: str) -> None:
        """Character by character: insert mode, no autowrap."""
        cursor = self.cursor
        for char in data:
            width = char_width(char)
            if width == 0:
                self._combine(char)
                continue
            if cursor.x + width > self.columns:
                if modes.DECAWM in self.mode:
                    self._wrap()
                else:
                    cursor.x = max(self.columns - width, 0)
            if modes.IRM in self.mode:
                self.insert_characters(width)
            line = self.buffer[cursor.y]
            cells = self._cells_for(cursor.attrs)
            self._clear_halves(line, cursor.x, width)
            line[cursor.x] = cells[char]
            if width == 2 and cursor.x + 1 < self.columns:
                line[cursor.x + 1] = cells[""]
            cursor.x = min(cursor.x + width, self.columns)
        self.dirty.add(cursor.y)

    def _clear_halves(self, line: Line, x: int, width: int) -> None:
        """Overwriting one half of a wide character removes the other half."""
        if x and x in line and line[x].data == "":
            line[x - 1] = self.default_char
        end = x + width
        if end in line and line[end].data == "":
            line[end] = self.default_char

    def _combine(self, char: str) -> None:
        if not self.cursor.x:
            return
        x = self.cursor.x - 1
        pen = self._pen
        if self.cursor.y == self.lines - 1 and x < len(pen):
            if pen[x] == "" and x:
                x -= 1
            pen[x] = with_mark(pen[x], char)
            self.dirty.add(self.cursor.y)
            return
        line = self._line()
        if line[x].data == "" and x:
            x -= 1
        line[x] = combined(line[x], char)
        self.dirty.add(self.cursor.y)

    def _cells_for(self, attrs: Char) -> _Cells:
        style = attrs[1:]
        cells = self._cells.get(style)
        if cells is None:
            if len(self._cells) > 256:
                self._cells.clear()
            cells = self._cells[style] = _Cells(attrs)
        return cells

    def alignment_display(self) -> None:
        line = dict.fromkeys(range(self.columns), self.default_char._replace(data="E"))
        for y in range(self.lines):
            self.buffer[y].update(line)
        self.dirty.update(range(self.lines))

    # pyte moves and erases cells one by one, and so may leave half of a wide character.

    def insert_characters(self, count: int | None = None) -> None:
        super().insert_characters(count)
        line = self.buffer[self.cursor.y]
        fit(line, self.columns)
        if line.folded:
            line.setdefault(self.columns - 1, self.default_char)

    def delete_characters(self, count: int | None = None) -> None:
        super().delete_characters(count)
        fit(self.buffer[self.cursor.y], self.columns)
        self._line().folded = False

    def erase_characters(self, count: int | None = None) -> None:
        self._erase(self.cursor.x, min(self.cursor.x + (count or 1), self.columns))

    def erase_in_line(self, how: int = 0, private: bool = False) -> None:
        x = self.cursor.x
        self._erase(*{0: (x, self.columns), 1: (0, min(x + 1, self.columns)), 2: (0, self.columns)}[how])

    def _erase(self, first: int, end: int) -> None:
        """Erase cells of the line with the cursor."""
        line = self._line()
        self._clear_halves(line, first, end - first)
        line.update(dict.fromkeys(range(first, end), self._blank()))
        self.dirty.add(self.cursor.y)
        if end == self.columns:
            line.folded = False
            if not first:
                self._cut(self.cursor.y)

    def _blank(self) -> Char:
        """An erased cell: of the pen's attributes it takes the background alone (terminfo's bce)."""
        background = self.cursor.attrs.bg
        return self.default_char if background == "default" else self.default_char._replace(bg=background)

    # -- scrolling -----------------------------------------------------------------------------------------------------

    def index(self) -> None:
        if self.margins is None and self.cursor.y == self.lines - 1:
            if not self._arriving:
                self.dirty.update(range(self.lines))
            if self._pen:
                self._arriving.append("".join(self._pen))
                self._pen = []
            else:
                self._arriving.append(self._buffer.pop(self.lines - 1, ""))
            return
        top, bottom = self.margins or (0, self.lines - 1)
        if self.cursor.y == bottom:
            self._cut(bottom + 1)
            super().index()
            self._cut(top)
        else:
            super().index()

    def reverse_index(self) -> None:
        top, bottom = self.margins or (0, self.lines - 1)
        moves = self.cursor.y == top
        super().reverse_index()
        if moves:
            self._cut(top)
            self._cut(bottom + 1)

    def insert_lines(self, count: int | None = None) -> None:
        super().insert_lines(count)
        self._cut(self.cursor.y)
        self._cut((self.margins.bottom if self.margins else self.lines - 1) + 1)

    def delete_lines(self, count: int | None = None) -> None:
        bottom = self.margins.bottom if self.margins else self.lines - 1
        self._cut(bottom + 1)
        for y in range(self.cursor.y, bottom + 1):
            _ = self.buffer[y]  # makes it: where a line was never drawn in, pyte would leave the one that is to go
        super().delete_lines(count)
        self._cut(self.cursor.y)

    def erase_in_display(self, how: int = 0, *args: int, **kwargs: bool) -> None:
        if how == 3:
            self.scrollback.clear()
            self.dirty.update(range(self.lines))
            return
        if not self.alternate and how != 1:
            self._below = []
        y, blank = self.cursor.y, self._blank()
        erased = {0: range(y + 1, self.lines), 1: range(y), 2: range(self.lines)}[how]
        lines = self.buffer
        for each in erased:
            lines.pop(each, None)
            if blank != self.default_char:  # pyte leaves cells alone that nothing was drawn in
                lines[each].update(dict.fromkeys(range(self.columns), blank))
        self.dirty.update(erased)
        if 0 in erased:
            self._cut(0)
        if how != 2:
            self.erase_in_line(how)
        elif not self.alternate:
            self._cleared = self._scrolled

    def scroll_up(self, count: int = 0) -> None:
        """SU: the lines between the margins move up, and the cursor stays where it is."""
        y = self.cursor.y
        self.cursor.y = self.margins.bottom if self.margins else self.lines - 1
        for _ in range(min(max(count, 1), self.lines)):
            self.index()
        self.cursor.y = y

    def scroll_down(self, count: int = 0) -> None:
        """SD: the lines between the margins move down."""
        y = self.cursor.y
        self.cursor.y = self.margins.top if self.margins else 0
        for _ in range(min(max(count, 1), self.lines)):
            self.reverse_index()
        self.cursor.y = y

    def repeat(self, count: int = 0) -> None:
        """REP: draw the last character again."""
        if self._last_drawn:
            self.draw(self._last_drawn * min(max(count, 1), self.columns * self.lines))

    def tabs(self, count: int = 0) -> None:
        """CHT: go on by so many tab stops."""
        for _ in range(min(max(count, 1), self.columns)):
            self.tab()

    def back_tabs(self, count: int = 0) -> None:
        """CBT: go back by so many tab stops."""
        before = [0, *sorted(stop for stop in self.tabstops if stop < self.cursor.x)]
        self.cursor.x = before[-min(max(count, 1), len(before))]

    def save_place(self, *_: int) -> None:
        """SCOSC, as ESC 7."""
        self.save_cursor()

    def restore_place(self, *_: int) -> None:
        """SCORC, as ESC 8."""
        self.restore_cursor()

    # -- modes ---------------------------------------------------------------------------------------------------------

    def set_mode(self, *numbers: int, **keywords: bool) -> None:
        if keywords.get("private"):
            if ALTERNATE_MODES.intersection(numbers) and self._main is None:
                cursor = Cursor(self.cursor.x, self.cursor.y, self.cursor.attrs)
                self._main = _MainScreen(dict(self.buffer), (self.lines, self.columns), cursor)
                self.buffer.clear()
                self.dirty.update(range(self.lines))
            # 3 would make the screen 132 columns wide; the window decides that here.
            numbers = tuple(number for number in numbers if number not in ALTERNATE_MODES and number != 3)
        super().set_mode(*numbers, **keywords)

    def reset_mode(self, *numbers: int, **keywords: bool) -> None:
        if keywords.get("private"):
            if ALTERNATE_MODES.intersection(numbers) and self._main is not None:
                self._leave_alternate(self._main)
            numbers = tuple(number for number in numbers if number not in ALTERNATE_MODES and number != 3)
        super().reset_mode(*numbers, **keywords)

    def _leave_alternate(self, main: _MainScreen) -> None:
        """Show the main screen again, in the size that the window has now."""
        size = self.lines, self.columns
        self.buffer.clear()
        self._main = None
        self.buffer.update(main.buffer)
        self.lines, self.columns = main.size
        self.cursor.x, self.cursor.y = main.cursor.x, main.cursor.y
        self.cursor.attrs = self.default_char
        self.margins = None
        self.resize(*size)
        self.dirty.update(range(self.lines))

    def save_cursor(self) -> None:
        """Save one cursor position, as xterm does; pyte would keep them all."""
        self.savepoints.clear()
        super().save_cursor()

    def restore_cursor(self) -> None:
        saved = [point._replace(cursor=copy.copy(point.cursor)) for point in self.savepoints]
        super().restore_cursor()
        self.savepoints[:] = saved

    def reset(self) -> None:
        if self._arriving or self._pen:
            self._settle()
        self._main = None
        self._below = []
        self._cut(0)
        self._cleared = self._scrolled
        super().reset()

    def write_process_input(self, data: str) -> None:
        if len(self.answers) < MOST_ANSWERS:
            self.answers.append(data)

    # -- size ----------------------------------------------------------------------------------------------------------

    def resize(self, lines: int | None = None, columns: int | None = None) -> None:
        """Change the size. The text is folded anew; shrinking moves lines into the scrollback, growing brings them back."""
        lines = lines or self.lines
        columns = columns or self.columns
        if (lines, columns) == (self.lines, self.columns):
            return
        if self._arriving or self._pen:
            self._settle()
        self.tabstops = set(range(8, columns, 8))
        if self.alternate:
            narrower = columns < self.columns
            super().resize(lines, columns)
            for line in self.buffer.values():
                fit(line, columns)
                line.folded &= not narrower
            self.cursor.x, self.cursor.y = min(self.cursor.x, columns), min(self.cursor.y, lines - 1)
            self.dirty.intersection_update(range(lines))
        else:
            self._rearrange(lines, columns)

    def _rearrange(self, lines: int, columns: int) -> None:
        """Spread scrollback and screen over a window of another size."""
        cursor = self.cursor
        history = len(self._scrollback)
        oldest = self._scrolled - history
        screen = [self.row(y) for y in range(self.lines)]
        below = self._below if self._below_since == self._scrolled else []
        if below and ended(below[0]) == screen[-1]:
            screen[-1] = below[0]
        used = self.lines if below else max([cursor.y, *(y for y, row in enumerate(screen) if row)]) + 1
        rows = [*self._scrollback, *screen[:used], *below[1:]]
        saved = [(point.cursor, Marker(self._scrolled + point.cursor.y, point.cursor.x)) for point in self.savepoints]
        top, first = history, max(self._cleared - oldest, 0)
        place = history + cursor.y, cursor.x
        if columns != self.columns:
            markers = [marker for marker in self.markers if marker.line >= oldest] + [marker for _, marker in saved]
            places = [(top, 0), (first, 0), *((marker.line - oldest, marker.column) for marker in markers)]
            wraps_next = cursor.x >= self.columns
            rows, place, ((top, _), (first, _), *moved) = rewrap(rows, columns, place, places, wraps_next=wraps_next)
            for marker, (index, x) in zip(markers, moved, strict=True):
                marker.line, marker.column = oldest + index, x
        end = len(rows) - lines
        top = min(max(end, first if used == self.lines else top), place[0])
        self._scrollback = deque(rows[:top], maxlen=self._most_above(lines, columns))
        self._scrolled = oldest + top
        self._cleared = oldest + first
        self._below = rows[top + lines - 1 :] if end > top else []
        self._below_since = self._scrolled
        self.buffer.clear()
        for y, row in enumerate(rows[top : top + lines]):
            if row:
                self._fill(self._buffer[y], row)
        self.lines, self.columns = lines, columns
        self.margins = None
        cursor.y, cursor.x = place[0] - top, min(place[1], columns)
        for point, marker in saved:
            point.y, point.x = max(marker.line - self._scrolled, 0), marker.column
        if self._below:
            self._cut(lines)
        self.dirty.clear()
        self.dirty.update(range(lines))

    def _most_above(self, lines: int, columns: int) -> int:
        """The rows of scrollback in which the text of the widest window has room."""
        self._widest = max(self._widest, columns)
        if columns == self._widest:
            return SCROLLBACK
        return (SCROLLBACK + max(lines, self.lines)) * -(-self._widest // max(columns - 1, 1))


def _row_of(line: Line | None) -> Row:
    return as_row(line, folded=line.folded) if line else ""


def _with_second_halves(text: str, digits: str) -> Sequence[str]:
    """The cells of a text whose widths are `digits`."""
    cells = []
    for char, digit in zip(text, digits, strict=True):
        cells.append(char)
        if digit == "2":
            cells.append("")
    return cells


def _fill(line: Line, x: int, text: str, digits: str, cells: _Cells) -> int:
    """Put characters into a line of pyte's buffer; returns the place after them. `digits` are their widths, '' if all are 1."""
    parts = _with_second_halves(text, digits) if "2" in digits else text
    end = x + len(parts)
    line.update(zip(range(x, end), map(cells.__getitem__, parts)))  # noqa: B905
    return end
