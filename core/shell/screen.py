"""The picture of a terminal: pyte's VT emulation with scrollback, alternate screen, right widths, and a fast way for text.

Only the thread that draws touches a screen; `Terminal.update` feeds it.
"""

from __future__ import annotations

import re
from collections import deque
from typing import Any

from day6_tui.core.session.harmless import for_emulation
from day6_tui.core.shell.light_pyte import Char, Cursor, charsets, modes
from day6_tui.core.shell.light_pyte import Screen as PyteScreen
from day6_tui.core.shell.light_pyte import Stream as PyteStream
from day6_tui.core.shell.rows import Row, as_row, cells_of, combined, fit, row_text, wrapped
from day6_tui.core.shell.width import char_width

SCROLLBACK = 5000
"""Lines kept above the screen."""

MOST_ANSWERS = 100
"""Queries answered in one go: a file full of them is no conversation."""

ALTERNATE_MODES = frozenset({47, 1047, 1049})
BRACKETED_PASTE = 2004 << 5
APPLICATION_CURSOR_KEYS = 1 << 5

_PLAIN = re.compile(r"[^\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f]*")


def is_plain(text: str) -> bool:
    """Whether a text has no control characters but newline, carriage return and tab."""
    match = _PLAIN.fullmatch(text)
    return match is not None


class Stream(PyteStream):
    """pyte's parser, which here skips a sequence it cannot understand instead of dropping the rest of the text."""

    @property
    def between_sequences(self) -> bool:
        return bool(self._taking_plain_text)

    def _send_to_parser(self, data: str) -> bool | None:
        try:
            return super()._send_to_parser(data)
        except (TypeError, ValueError, LookupError, NameError, AttributeError, ArithmeticError):
            return True  # the parser was reset: what follows is text again


class Screen(PyteScreen):
    """A VT100 screen of `columns` x `lines` cells with `scrollback` above it."""

    def __init__(self, columns: int, lines: int) -> None:
        self.scrollback: deque[Row] = deque(maxlen=SCROLLBACK)
        self.scrolled = 0
        """Lines that ever left the screen at the top; a view that is scrolled back uses it to stay where it is."""
        self.answers: list[str] = []
        """What the terminal has to say to the program (answers to queries), for `Terminal` to deliver."""
        self._cells: dict[Any, dict[str, Char]] = {}
        self._main: tuple[dict[int, Any], Cursor] | None = None
        super().__init__(columns, lines)
        self._stream = Stream(self)

    # -- what the view reads -------------------------------------------------------------------------------------------

    def row(self, y: int) -> Row:
        """Line `y` of the screen, 0 at the top."""
        return as_row(self.buffer.get(y, {}))

    def history_row(self, index: int) -> Row:
        """Line `index` of the scrollback, 0 the oldest."""
        return self.scrollback[index]

    @property
    def text(self) -> str:
        """The screen as plain lines, for tests and copying."""
        return "\n".join(row_text(self.row(y)) for y in range(self.lines)).rstrip()

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

    def feed(self, text: str) -> None:
        """Show what a program wrote."""
        text = for_emulation(text)
        if self._stream.between_sequences and self._is_simple() and is_plain(text):
            self._feed_plain(text)
        else:
            self._stream.feed(text)

    def _is_simple(self) -> bool:
        return not self.margins and not self.charset and modes.IRM not in self.mode and modes.DECAWM in self.mode

    def _feed_plain(self, text: str) -> None:
        lines = text.split("\n")
        if len(lines) > 2 * self.lines and not self.alternate and self.cursor.attrs == self.default_char:
            lines = self._skip_to_the_end(lines)
        last = len(lines) - 1
        for index, line in enumerate(lines):
            for number, piece in enumerate(line.split("\r")):
                if number:
                    self.cursor.x = 0
                if "\t" in piece:
                    self._draw_with_tabs(piece)
                elif piece:
                    self.draw(piece)
            if index < last:
                self.linefeed()

    def _draw_with_tabs(self, text: str) -> None:
        for number, piece in enumerate(text.split("\t")):
            if number:
                self.tab()
            if piece:
                self.draw(piece)

    def _skip_to_the_end(self, lines: list[str]) -> list[str]:
        """Put what would scroll through straight into the scrollback; return the lines still to be drawn."""
        self.draw(lines[0].rstrip("\r").expandtabs(8))
        for y in range(self.cursor.y + 1):
            self._remember(as_row(self.buffer[y]))
        end = len(lines) - self.lines
        for line in lines[1:end][-SCROLLBACK:]:
            line = line.rstrip("\r").rpartition("\r")[2].expandtabs(8)
            for row in wrapped(line, self.columns):
                self._remember(row.rstrip(" "))
        self.buffer.clear()
        self.cursor.x = self.cursor.y = 0
        self.dirty.update(range(self.lines))
        return lines[end:]

    def draw(self, data: str) -> None:
        cursor = self.cursor
        if data.isascii() and data.isprintable() and self._is_simple() and cursor.x + len(data) <= self.columns:
            cells = self._cells_for(cursor.attrs)
            line = self.buffer[cursor.y]
            x = cursor.x
            self._clear_halves(line, x, len(data))
            for char in data:
                line[x] = cells[char] if char in cells else self._new_cell(cells, char)
                x += 1
            cursor.x = x
            self.dirty.add(cursor.y)
            return
        if self.charset or self.g0_charset is not charsets.LAT1_MAP:
            data = data.translate(self.g1_charset if self.charset else self.g0_charset)
        self._draw_slowly(data)

    def _draw_slowly(self, data: str) -> None:
        """Wraps, wide characters, combining marks, insert mode."""
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
            line[cursor.x] = cells[char] if char in cells else self._new_cell(cells, char)
            if width == 2 and cursor.x + 1 < self.columns:
                line[cursor.x + 1] = cells[""] if "" in cells else self._new_cell(cells, "")
            cursor.x = min(cursor.x + width, self.columns)
        self.dirty.add(cursor.y)

    def _clear_halves(self, line: Any, x: int, width: int) -> None:
        """Overwriting one half of a wide character removes the other half."""
        if x and x in line and line[x].data == "":
            line[x - 1] = self.default_char
        end = x + width
        if end in line and line[end].data == "":
            line[end] = self.default_char

    def _combine(self, char: str) -> None:
        if not self.cursor.x:
            return
        line = self.buffer[self.cursor.y]
        x = self.cursor.x - 1
        if line[x].data == "" and x:
            x -= 1
        line[x] = combined(line[x], char)
        self.dirty.add(self.cursor.y)

    def _cells_for(self, attrs: Char) -> dict[str, Char]:
        style = attrs[1:]
        cells = self._cells.get(style)
        if cells is None:
            if len(self._cells) > 256:
                self._cells.clear()
            cells = self._cells[style] = {}
        return cells

    def _new_cell(self, cells: dict[str, Char], char: str) -> Char:
        if len(cells) > 4096:
            cells.clear()
        cell: Char = self.cursor.attrs._replace(data=char)
        cells[char] = cell
        return cell

    # pyte moves and erases cells one by one, and so may leave half of a wide character.

    def insert_characters(self, count: int | None = None) -> None:
        super().insert_characters(count)
        fit(self.buffer[self.cursor.y], self.columns)

    def delete_characters(self, count: int | None = None) -> None:
        super().delete_characters(count)
        fit(self.buffer[self.cursor.y], self.columns)

    def erase_characters(self, count: int | None = None) -> None:
        super().erase_characters(count)
        fit(self.buffer[self.cursor.y], self.columns)

    def erase_in_line(self, how: int = 0, private: bool = False) -> None:
        super().erase_in_line(how, private)
        fit(self.buffer[self.cursor.y], self.columns)

    # -- scrolling -----------------------------------------------------------------------------------------------------

    def index(self) -> None:
        if self.margins is None and self.cursor.y == self.lines - 1:
            buffer = self.buffer
            if not self.alternate:
                self._remember(as_row(buffer[0]) if 0 in buffer else "")
            for y in range(self.lines - 1):
                if y + 1 in buffer:
                    buffer[y] = buffer[y + 1]
                else:
                    buffer.pop(y, None)
            buffer.pop(self.lines - 1, None)
            self.dirty.update(range(self.lines))
            return
        super().index()

    def _remember(self, row: Row) -> None:
        self.scrollback.append(row)
        self.scrolled += 1

    def erase_in_display(self, how: int = 0, *args: Any, **kwargs: Any) -> None:
        if how == 3:
            self.scrollback.clear()
            self.dirty.update(range(self.lines))
            return
        super().erase_in_display(how, *args, **kwargs)

    # -- modes ---------------------------------------------------------------------------------------------------------

    def set_mode(self, *numbers: int, **keywords: Any) -> None:
        if keywords.get("private"):
            if ALTERNATE_MODES.intersection(numbers) and self._main is None:
                self._main = (dict(self.buffer), Cursor(self.cursor.x, self.cursor.y, self.cursor.attrs))
                self.buffer.clear()
                self.dirty.update(range(self.lines))
            # 3 would make the screen 132 columns wide; the window decides that here.
            numbers = tuple(number for number in numbers if number not in ALTERNATE_MODES and number != 3)
        super().set_mode(*numbers, **keywords)

    def reset_mode(self, *numbers: int, **keywords: Any) -> None:
        if keywords.get("private"):
            if ALTERNATE_MODES.intersection(numbers) and self._main is not None:
                lines, cursor = self._main
                self._main = None
                self.buffer.clear()
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

    def reset(self) -> None:
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
            shift = -min(lines - self.lines, len(self.scrollback))
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
        rows = [self.scrollback.pop() for _ in range(count)][::-1]
        self.scrolled -= count
        for y in sorted((y for y in self.buffer), reverse=True):
            self.buffer[y + count] = self.buffer.pop(y)
        for y, row in enumerate(rows):
            self.buffer[y].update(enumerate(cells_of(row)))
        self.cursor.y += count
