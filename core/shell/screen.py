"""The picture of a terminal: pyte's VT emulation with scrollback, alternate screen, right widths, and fast ways for floods.

Only the thread that draws touches a screen; `Terminal.update` feeds it.

Scrolling text costs little, because a line that leaves the screen is never drawn cell by cell: while the cursor is in
the last line, whole lines of text become rows at once (`rush`), long ones are folded into rows (`_flow`), and the rows only
queue up below the screen (`_arriving`). Reading `buffer` or `scrollback` first moves them in (`_settle`).
"""

from __future__ import annotations

import copy
import re
from collections import deque
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

from day6_tui.core.session.harmless import for_emulation
from day6_tui.core.shell.light_pyte import Char, Cursor, charsets, modes
from day6_tui.core.shell.light_pyte import Screen as PyteScreen
from day6_tui.core.shell.light_pyte import Stream as PyteStream
from day6_tui.core.shell.rows import (
    PLAIN_STYLE,
    Row,
    Run,
    Style,
    as_row,
    cells_of,
    combined,
    fit,
    folded,
    folded_runs,
    row_text,
    with_mark,
    without_end,
)
from day6_tui.core.shell.sequences import NEVER, Parser, colour_numbers
from day6_tui.core.width import char_width, fitting, text_width, widths

if TYPE_CHECKING:
    from day6_tui.core.shell.light_pyte import Line

SCROLLBACK = 5000
"""Lines kept above the screen."""

MOST_ANSWERS = 100
"""Most replies to queries that wait to be delivered: a file full of queries needs no more."""

MOST_ARRIVING = 512
"""Rows that queue up below the screen after a text was fed."""

ALTERNATE_MODES = frozenset({47, 1047, 1049})
BRACKETED_PASTE = 2004 << 5
APPLICATION_CURSOR_KEYS = 1 << 5

_ODD = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1a\x1c-\x1f\x7f-\x9f]")
"""Characters because of which a line cannot be taken as a whole."""
_ODD_SEQUENCE = re.compile(r"\x1b(?!\[(?:[0-9;]*m|K))")
_COLOUR = re.compile(r"\x1b\[([0-9;]*m|K)")
"""Colours, and the emptying of the rest of the line, with which grep and GCC surround every colour."""
_PIECE = re.compile(r"([^\x1b\t\r\n]+)|([\t\r\n])|\x1b\[([0-9;]*m|K)")
_NARROW = (
    " -~\xa0-\xac\xae-\u02ff\u0370-\u0377\u037a-\u037f\u0384-\u038a\u038c\u038e-\u03a1\u03a3-\u0482"
    "\u048a-\u052f\u0531-\u0556\u0559-\u058a\u05d0-\u05ea\u0620-\u064a\ufffd"
)
"""Latin, Greek, Cyrillic, Armenian, Hebrew and Arabic letters: one cell each."""
_WIDE = "\u3000-\u3029\u3041-\u3096\u30a1-\u30fa\u3400-\u4dbf\u4e00-\u9fff\uac00-\ud7a3\uff01-\uff60"
_NOT_NARROW = re.compile(f"[^{_NARROW}]")
"""Characters that may take no cell, or two."""
_NOT_COMMON = re.compile(f"[^\r\n{_NARROW}{_WIDE}]")
"""Characters that may take no cell."""
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


class Screen(PyteScreen):
    """A VT100 screen of `columns` x `lines` cells with `scrollback` above it."""

    def __init__(self, columns: int, lines: int) -> None:
        self._scrollback: deque[Row] = deque(maxlen=SCROLLBACK)
        self._scrolled = 0
        self._arriving: list[Row | Line | None] = []
        """Rows above the one with the cursor that have not moved into the screen yet: rows, or lines of pyte's buffer."""
        self._pen: list[str] = []
        """What was drawn in the last line so far, cell by cell, while it is plain text: it is no line of pyte's buffer yet."""
        self._last_drawn = ""
        """What REP repeats."""
        self._passed = 0
        """Rows that went by and are not even kept in the scrollback."""
        self._odd_before = 0
        """In the text that is being fed: up to here it has to be read character by character."""
        self._odd_at = -1
        """The position of the next control character in it that does not belong in a line of text."""
        self._style_of: Char | None = None
        self._style_now = PLAIN_STYLE
        self.answers: list[str] = []
        """The terminal's replies to the program's queries, for `Terminal` to deliver."""
        self._cells: dict[tuple[object, ...], _Cells] = {}
        self._colours: dict[tuple[Char, str], Char] = {}
        self._main: tuple[dict[int, Line], Cursor] | None = None
        super().__init__(columns, lines)
        self._parser = Parser(self)

    # -- what the view reads -------------------------------------------------------------------------------------------

    @property
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
        return as_row(self.buffer.get(y, {}))

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
        self._odd_before, self._odd_at = 0, -1
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

    # -- whole lines ---------------------------------------------------------------------------------------------------

    def _is_simple(self) -> bool:
        """Whether text goes from cell to cell and on to the next line, as it nearly always does."""
        mode = self.mode
        return (
            modes.IRM not in mode and modes.DECAWM in mode and not self.margins and self.g0_charset is charsets.LAT1_MAP
        )

    def rush(self, text: str, start: int) -> int:
        if self.cursor.x or start < self._odd_before or not self._is_at_the_empty_end():
            return start
        if not self._is_simple() or modes.DECSCNM in self.mode or self.columns < 2:
            return start
        if start > self._odd_at:
            odd = _ODD.search(text, start)
            self._odd_at = len(text) if odd is None else odd.start()
        end = self._odd_at
        coloured = text.find("\x1b", start, end) >= 0
        if coloured and (sequence := _ODD_SEQUENCE.search(text, start, end)) is not None:
            end = sequence.start()
        self._odd_before = end
        cut = text.rfind("\r\n", start, end)
        if cut < 0:
            return start
        return self._take_lines(text[start:cut], start, coloured)

    def _take_lines(self, chunk: str, start: int, coloured: bool) -> int:
        """Lines without odd characters, before the last of which a newline is missing; returns the place after what was taken."""
        lines = chunk.split("\r\n")
        regular = chunk.count("\r") == chunk.count("\n") == len(lines) - 1
        if (
            regular
            and not coloured
            and "\t" not in chunk
            and chunk.isascii()
            and len(max(lines, key=len)) <= self.columns
        ):
            style = self._style()
            if style == PLAIN_STYLE:
                self._arrive(lines)
            else:
                self._arrive([((line, style),) if line else "" for line in lines])
            return start + len(chunk) + 2
        rows: list[Row] = []
        if regular and not coloured and not _NOT_COMMON.search(chunk) and self._style() == PLAIN_STYLE:
            for line in lines:
                if 2 * len(line) <= self.columns:
                    rows.append(line)
                else:
                    rows += folded(line, self.columns)
            self._arrive(rows)
            return start + len(chunk) + 2
        for line in lines:
            made = self._rows_of(line)
            if made is None:
                self._arrive(rows)
                rows = []
                self._draw_line(line)
            else:
                rows += made
        self._arrive(rows)
        return start + len(chunk) + 2

    def _draw_line(self, line: str) -> None:
        """Draw a line of text, colours, tabs, carriage returns and bare newlines; then begin the next."""
        for found in _PIECE.finditer(line):
            if found[1]:
                self.draw(found[1])
            elif found[2]:
                self.control(found[2])
            elif found[3] == "K":
                self.erase_in_line()
            else:
                self.colour(found[3][:-1])
        self.new_line()

    def _rows_of(self, line: str) -> list[Row] | None:
        """The rows a line takes that begins at the left edge; None if it has to be drawn. Sets the colour it ends with."""
        line = line.rstrip("\r")
        if "\n" in line or "\r" in line:
            return None
        if not line.isascii() and "0" in widths(_COLOUR.sub("", line).replace("\t", "")):
            return None  # characters that go onto the one before
        if "\x1b" in line:
            return self._coloured_rows_of(line)
        style = self._style()
        if "\t" in line:
            if style != PLAIN_STYLE or not self._tabs_are_regular():
                return None
            line = _expanded(line.rstrip("\t"))
            if text_width(line) > self.columns:
                return None
            return [line]
        rows = folded(line, self.columns)
        return list(rows) if style == PLAIN_STYLE else [((row, style),) if row else "" for row in rows]

    def _coloured_rows_of(self, line: str) -> list[Row] | None:
        before = self.cursor.attrs
        runs: list[Run] = []
        used = 0
        width = len if line.isascii() else text_width
        beyond: Style | None = None
        for index, piece in enumerate(_COLOUR.split(line)):
            if index % 2:
                if piece == "K":
                    background = self.cursor.attrs.bg  # as `_blank`, whose cell costs a quarter of such a line
                    beyond = PLAIN_STYLE if background == "default" else PLAIN_STYLE._replace(bg=background)
                else:
                    self.colour(piece[:-1])
            elif "\t" in piece:
                style = self._style()
                for number, part in enumerate(piece.split("\t")):
                    if number:
                        blanks = 8 - used % 8
                        runs.append((" " * blanks, PLAIN_STYLE if beyond is None else beyond))
                        used += blanks
                    if part:
                        runs.append((part, style))
                        used += width(part)
            elif piece:
                runs.append((piece, self._style()))
                used += width(piece)
        special = beyond is not None or "\t" in line
        if special and (used > self.columns or not self._tabs_are_regular()):
            self.cursor.attrs = before
            return None
        if beyond is not None and beyond != PLAIN_STYLE and used < self.columns:
            runs.append((" " * (self.columns - used), beyond))
        return folded_runs(runs, self.columns) if used > self.columns else [tuple(runs)]

    def _tabs_are_regular(self) -> bool:
        return self.tabstops == _regular_tabs(self.columns)

    def _style(self) -> Style:
        attrs = self.cursor.attrs
        if attrs is not self._style_of:
            self._style_of = attrs
            self._style_now = Style(*attrs[1:])
        return self._style_now

    def _arrive(self, rows: Sequence[Row]) -> None:
        """Rows that scroll in from below, above the line with the cursor."""
        surplus = len(rows) - SCROLLBACK - self.lines
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
        x = 0
        for text, style in ((row, PLAIN_STYLE),) if isinstance(row, str) else row:
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
            "" if not row else as_row(row) if isinstance(row, dict) else without_end(row) for row in rows[-SCROLLBACK:]
        )

    # -- drawing -------------------------------------------------------------------------------------------------------

    def draw(self, data: str) -> None:
        self._last_drawn = data[-1:]
        if self.g0_charset is not charsets.LAT1_MAP:
            data = data.translate(self.g0_charset)
        if modes.IRM in self.mode or modes.DECAWM not in self.mode or self.columns < 2:
            self._draw_slowly(data)
            return
        digits = "" if data.isascii() or not _NOT_NARROW.search(data) else widths(data)
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
            self.dirty.add(cursor.y)
            self.carriage_return()
            self.linefeed()
            if end - start > columns and self._is_at_the_empty_end():
                rows = folded(data[start:], columns)
                style = self._style()
                start = end - len(rows.pop())
                self._arrive(list(rows) if style == PLAIN_STYLE else [((row, style),) for row in rows])
            count = fitting(digits, start, columns) if digits else min(columns, end - start)
            self._put(data[start : start + count], digits[start : start + count])
            start += count

    def _is_at_the_empty_end(self) -> bool:
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
        if self.cursor.y != self.lines - 1 or modes.DECSCNM in self.mode or self._style() != PLAIN_STYLE:
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
                    self.dirty.add(cursor.y)
                    self.carriage_return()
                    self.linefeed()
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
        fit(self.buffer[self.cursor.y], self.columns)

    def delete_characters(self, count: int | None = None) -> None:
        super().delete_characters(count)
        fit(self.buffer[self.cursor.y], self.columns)

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
        super().index()

    def _remember(self, row: Row) -> None:
        self._scrollback.append(row)
        self._scrolled += 1

    def erase_in_display(self, how: int = 0, *args: int, **kwargs: bool) -> None:
        if how == 3:
            self.scrollback.clear()
            self.dirty.update(range(self.lines))
            return
        y, blank = self.cursor.y, self._blank()
        erased = {0: range(y + 1, self.lines), 1: range(y), 2: range(self.lines)}[how]
        lines = self.buffer
        for each in erased:
            lines.pop(each, None)
            if blank != self.default_char:  # pyte leaves cells alone that nothing was drawn in
                lines[each].update(dict.fromkeys(range(self.columns), blank))
        self.dirty.update(erased)
        if how != 2:
            self.erase_in_line(how)

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
                self._main = (dict(self.buffer), Cursor(self.cursor.x, self.cursor.y, self.cursor.attrs))
                self.buffer.clear()
                self.dirty.update(range(self.lines))
            # 3 would make the screen 132 columns wide; the window decides that here.
            numbers = tuple(number for number in numbers if number not in ALTERNATE_MODES and number != 3)
        super().set_mode(*numbers, **keywords)

    def reset_mode(self, *numbers: int, **keywords: bool) -> None:
        if keywords.get("private"):
            if ALTERNATE_MODES.intersection(numbers) and self._main is not None:
                self.buffer.clear()
                lines, cursor = self._main
                self._main = None
                # The window may have become smaller meanwhile: the line with the cursor stays in sight.
                shift = max(cursor.y - self.lines + 1, 0)
                for y, line in sorted(lines.items()):
                    if y < shift:
                        self._remember(as_row(line))
                    elif y - shift < self.lines:
                        self.buffer[y - shift] = line
                        fit(line, self.columns)
                self.cursor.x, self.cursor.y = min(cursor.x, self.columns), cursor.y - shift
                self.cursor.attrs = self.default_char
                self.margins = None
                self.dirty.update(range(self.lines))
            numbers = tuple(number for number in numbers if number not in ALTERNATE_MODES and number != 3)
        super().reset_mode(*numbers, **keywords)

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
        super().reset()

    def write_process_input(self, data: str) -> None:
        if len(self.answers) < MOST_ANSWERS:
            self.answers.append(data)

    # -- size ----------------------------------------------------------------------------------------------------------

    def resize(self, lines: int | None = None, columns: int | None = None) -> None:
        """Change the size. Shrinking moves lines from the top into the scrollback, growing brings them back."""
        lines = lines or self.lines
        columns = columns or self.columns
        if (lines, columns) == (self.lines, self.columns):
            return
        if self._arriving or self._pen:
            self._settle()
        self.tabstops = set(range(8, columns, 8))
        if self.alternate:
            super().resize(lines, columns)
            for line in self.buffer.values():
                fit(line, columns)
            self.cursor.x, self.cursor.y = min(self.cursor.x, columns), min(self.cursor.y, lines - 1)
            self.dirty.intersection_update(range(lines))
            return
        used = max([self.cursor.y, *(y for y in self.buffer if self.buffer[y])], default=0) + 1
        shift = max(used - lines, 0)
        if shift:
            rows = [self.buffer.pop(y, None) for y in range(self.lines)]
            for row in rows[:shift]:
                self._remember(as_row(row) if row is not None else "")
            for y, row in enumerate(rows[shift:used]):
                if row is not None:
                    self.buffer[y] = row
            self.cursor.y -= shift
        elif lines > self.lines:
            shift = -min(lines - self.lines, len(self._scrollback))
            if shift and used == self.lines:
                self._bring_back(-shift)
        for y in [y for y in self.buffer if y >= lines]:
            del self.buffer[y]
        if columns < self.columns:
            for line in self.buffer.values():
                fit(line, columns)
        self.lines, self.columns = lines, columns
        self.margins = None
        self.cursor.y = min(max(self.cursor.y, 0), lines - 1)
        self.cursor.x = min(self.cursor.x, columns)
        self.dirty.clear()
        self.dirty.update(range(lines))

    def _bring_back(self, count: int) -> None:
        rows = [self._scrollback.pop() for _ in range(count)][::-1]
        self._scrolled -= count
        for y in sorted((y for y in self.buffer), reverse=True):
            self.buffer[y + count] = self.buffer.pop(y)
        for y, row in enumerate(rows):
            self.buffer[y].update(enumerate(cells_of(row)))
        self.cursor.y += count


@lru_cache(maxsize=8)
def _regular_tabs(columns: int) -> set[int]:
    return set(range(8, columns, 8))


def _expanded(line: str) -> str:
    """A line with blanks for its tabs."""
    if line.isascii():
        return line.expandtabs(8)
    parts: list[str] = []
    used = 0
    for number, part in enumerate(line.split("\t")):
        if number:
            blanks = 8 - used % 8
            parts.append(" " * blanks)
            used += blanks
        parts.append(part)
        used += text_width(part)
    return "".join(parts)


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
