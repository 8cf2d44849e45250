"""Whole lines of text that scroll in at the end of a screen: they become rows at once, without being drawn."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import TYPE_CHECKING

from day6_core.shell.screen.rows import PLAIN_STYLE, Row, Run, Style, folded, folded_runs, in_style
from day6_core.shell.screen.vt import DECSCNM
from day6_core.width import text_width, widths

if TYPE_CHECKING:
    from day6_core.shell.screen.screen import Screen

_ODD = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1a\x1c-\x1f\x7f-\x9f]")
"""Characters because of which a line cannot be taken as a whole."""
_ODD_SEQUENCE = re.compile(r"\x1b(?!\[(?:[0-9;]*m|K))")
_COLOUR = re.compile(r"\x1b\[([0-9;]*m|K)")
"""Colours, and the emptying of the rest of the line, with which grep and GCC surround every colour."""
_PIECE = re.compile(r"([^\x1b\t\r\n]+)|([\t\r\n])|\x1b\[([0-9;]*m|K)")
NARROW = (
    " -~\xa0-\xac\xae-\u02ff\u0370-\u0377\u037a-\u037f\u0384-\u038a\u038c\u038e-\u03a1\u03a3-\u0482"
    "\u048a-\u052f\u0531-\u0556\u0559-\u058a\u05d0-\u05ea\u0620-\u064a\ufffd"
)
"""Latin, Greek, Cyrillic, Armenian, Hebrew and Arabic letters: one cell each."""
WIDE = "\u3000-\u3029\u3041-\u3096\u30a1-\u30fa\u3400-\u4dbf\u4e00-\u9fff\uac00-\ud7a3\uff01-\uff60"
NOT_NARROW = re.compile(f"[^{NARROW}]")
"""Characters that may take no cell, or two."""
NOT_COMMON = re.compile(f"[^\r\n{NARROW}{WIDE}]")
"""Characters that may take no cell."""


class WholeLines:
    """Takes whole lines for a screen, while its cursor stands in an empty last line."""

    def __init__(self, screen: Screen) -> None:
        self._screen = screen
        self.odd_before = 0
        """In the text that is being fed: up to here it has to be read character by character."""
        self._odd_at = -1
        """The position of the next control character in it that does not belong in a line of text."""

    def begin(self) -> None:
        """Another text is being fed."""
        self.odd_before, self._odd_at = 0, -1

    def take(self, text: str, start: int) -> int:
        """Take as many lines as can be taken at once from `start`, the beginning of a line; returns where that ended."""
        screen = self._screen
        if screen.cursor.x or start < self.odd_before or not screen.is_at_the_empty_end():
            return start
        if not screen.is_simple() or DECSCNM in screen.mode or screen.columns < 2 or screen.goes_on():
            return start
        if text.find("\r\n", start) < 0:
            return start
        if start > self._odd_at:
            odd = _ODD.search(text, start)
            self._odd_at = len(text) if odd is None else odd.start()
        end = self._odd_at
        coloured = text.find("\x1b", start, end) >= 0
        if coloured and (sequence := _ODD_SEQUENCE.search(text, start, end)) is not None:
            end = sequence.start()
        self.odd_before = end
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
            and len(max(lines, key=len)) <= self._screen.columns
        ):
            self._screen.arrive(in_style(lines, self._screen.style()))
            return start + len(chunk) + 2
        rows: list[Row] = []
        if regular and not coloured and not NOT_COMMON.search(chunk) and self._screen.style() == PLAIN_STYLE:
            for line in lines:
                if 2 * len(line) <= self._screen.columns:
                    rows.append(line)
                else:
                    rows += folded(line, self._screen.columns)
            self._screen.arrive(rows)
            return start + len(chunk) + 2
        for line in lines:
            made = self._rows_of(line)
            if made is None:
                self._screen.arrive(rows)
                rows = []
                self._draw_line(line)
            else:
                rows += made
        self._screen.arrive(rows)
        return start + len(chunk) + 2

    def _draw_line(self, line: str) -> None:
        """Draw a line of text, colours, tabs, carriage returns and bare newlines; then begin the next."""
        for found in _PIECE.finditer(line):
            if found[1]:
                self._screen.draw(found[1])
            elif found[2]:
                self._screen.control(found[2])
            elif found[3] == "K":
                self._screen.erase_in_line()
            else:
                self._screen.colour(found[3][:-1])
        self._screen.new_line()

    def _rows_of(self, line: str) -> list[Row] | None:
        """The rows a line takes that begins at the left edge; None if it has to be drawn. Sets the colour it ends with."""
        line = line.rstrip("\r")
        if "\n" in line or "\r" in line:
            return None
        if not line.isascii() and "0" in widths(_COLOUR.sub("", line).replace("\t", "")):
            return None  # characters that go onto the one before
        if "\x1b" in line:
            return self._coloured_rows_of(line)
        style = self._screen.style()
        if "\t" in line:
            if style != PLAIN_STYLE or not self._tabs_are_regular():
                return None
            line = _expanded(line.rstrip("\t"))
            if text_width(line) > self._screen.columns:
                return None
            return [line]
        return list(in_style(folded(line, self._screen.columns), style))

    def _coloured_rows_of(self, line: str) -> list[Row] | None:
        screen = self._screen
        before = screen.cursor.attrs
        runs: list[Run] = []
        used = 0
        width = len if line.isascii() else text_width
        beyond: Style | None = None
        for index, piece in enumerate(_COLOUR.split(line)):
            if index % 2:
                if piece == "K":
                    background = screen.cursor.attrs.bg  # as `_blank`, whose cell costs a quarter of such a line
                    beyond = PLAIN_STYLE if background == "default" else PLAIN_STYLE._replace(bg=background)
                else:
                    screen.colour(piece[:-1])
            elif "\t" in piece:
                style = screen.style()
                for number, part in enumerate(piece.split("\t")):
                    if number:
                        blanks = 8 - used % 8
                        runs.append((" " * blanks, PLAIN_STYLE if beyond is None else beyond))
                        used += blanks
                    if part:
                        runs.append((part, style))
                        used += width(part)
            elif piece:
                runs.append((piece, screen.style()))
                used += width(piece)
        special = beyond is not None or "\t" in line
        if special and (used > screen.columns or not self._tabs_are_regular()):
            screen.cursor.attrs = before
            return None
        if beyond is not None and beyond != PLAIN_STYLE and used < screen.columns:
            runs.append((" " * (screen.columns - used), beyond))
        return folded_runs(runs, screen.columns) if used > screen.columns else [tuple(runs)]

    def _tabs_are_regular(self) -> bool:
        return self._screen.tabstops == _regular_tabs(self._screen.columns)


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
