"""Text and simple control characters at the end of a screen: they go into its last line without a call for each.

That is what a program prints that has something else than text in its lines: a progress bar, another program's file, noise.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from day6_core.shell.screen.cells import HALF
from day6_core.shell.screen.rows import FoldedText, Row
from day6_core.shell.screen.vt import LNM
from day6_core.shell.screen.whole_lines import NARROW, WIDE
from day6_core.width import char_width

if TYPE_CHECKING:
    from day6_core.shell.screen.screen import Screen

MOST_AT_ONCE = 4096
"""Characters that are taken before the time is looked at."""

_PART = re.compile(
    rf"([{NARROW}]+)|([{WIDE}]+)|([^\x00-\x1f\x7f-\x9f])"  # 1, 2: text of so many cells a character; 3: any other character
    r"|(\r?\n|[\x0b\x0c])"  # 4: down a line
    r"|([\r\b\t])"  # 5: elsewhere in the line
    r"|([\x07\x18\x1a]|\x1b(?:[0-69<-BFGI-LN-OQ-WYZ\\`abd-~]|(?=[^\x00-\x9f])))"  # 6: nothing happens
    r"|([\x00-\x1f\x7f-\x9f])"  # 7: what has to be read with more care
)


class RunningText:
    """Takes plain text for a screen whose cursor stands in a last line that is plain text, too."""

    def __init__(self, screen: Screen) -> None:
        self._screen = screen

    def take(self, text: str, start: int, whole_lines: int) -> int:
        """Take as much as can be taken at once from `start`; returns where that ended.

        From `whole_lines` on no more than the end of a line is taken: whole ones may follow.
        """
        screen = self._screen
        if not screen.is_simple() or LNM in screen.mode or screen.columns < 2 or not screen.pen_is_at_hand():
            return start
        cursor, columns, pen = screen.cursor, screen.columns, screen.pen
        rows: list[Row] = []
        x, last = cursor.x, ""
        at = start
        for found in _PART.finditer(text, start, start + MOST_AT_ONCE):
            kind, part = found.lastindex or 0, found[0]
            if kind <= 3:
                last = part
                width = kind if kind < 3 else char_width(part)
                if width == 0:
                    if x:
                        pen.mark(x, part)
                else:
                    room = (columns - x) // width
                    if len(part) > room:
                        if room:
                            pen.put(x, _cells(part[:room], width))
                        rows.append(pen.fold(x + room * width))
                        fitting = columns // width
                        rest = len(part) - (len(part) - room - 1) % fitting - 1
                        rows += [FoldedText(part[first : first + fitting]) for first in range(room, rest, fitting)]
                        part, x = part[rest:], 0
                    if x == len(pen.text):
                        pen.text += _cells(part, width)
                    else:
                        pen.put(x, _cells(part, width))
                    x += len(part) * width
            elif kind == 4:
                rows.append(pen.lift())
                if part == "\r\n":
                    x, at = 0, found.end()
                    if at >= whole_lines:
                        break
            elif kind == 5:
                if part == "\r":
                    x = 0
                elif part == "\b":
                    x = max(min(x, columns - 1) - 1, 0)
                else:
                    cursor.x = x
                    screen.tab()
                    x = cursor.x
            elif kind == 7:
                break
            at = found.end()
        cursor.x = x
        screen.ran(rows, last)
        return at


def _cells(text: str, width: int) -> str:
    """Characters of one width as `Pen.put` takes them."""
    return text if width == 1 else HALF.join(text) + HALF
