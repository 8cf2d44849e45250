"""What stood in a terminal, as text that another one can show again: lines and colours, nothing else."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from day6_core.shell.screen.rows import PLAIN_STYLE, Folded, Row, Style

if TYPE_CHECKING:
    from day6_core.shell.screen.screen import Screen

LINES = 500
"""Lines that are kept of a terminal."""

_COLOURS = ("black", "red", "green", "brown", "blue", "magenta", "cyan", "white")
_MARKS = {"bold": 1, "italics": 3, "underscore": 4, "blink": 5, "reverse": 7, "strikethrough": 9}
_KEPT = re.compile(r"\x1b\[[0-9;]*m|[^\x00-\x09\x0b-\x1f\x7f-\x9f]")


def transcript(screen: Screen, *, without_last: bool = False) -> str:
    """The last lines of a terminal. `without_last` leaves out the line with the cursor: a prompt that will come again."""
    history = len(screen.scrollback)
    rows = [screen.history_row(index) for index in range(max(0, history - LINES), history)]
    used = screen.cursor.y + (not without_last)
    rows += [screen.row(y) for y in range(used)]
    return "".join(_written(row) + "\n" * (not isinstance(row, Folded)) for row in rows[-LINES:]).removesuffix("\n")


def _written(row: Row) -> str:
    if isinstance(row, str):
        return row[:]
    return "".join(f"\x1b[{_codes(style)}m{text}\x1b[0m" if style != PLAIN_STYLE else text for text, style in row)


def _codes(style: Style) -> str:
    codes = [str(code) for name, code in _MARKS.items() if getattr(style, name)]
    codes += _colour(style.fg, 30) + _colour(style.bg, 40)
    return ";".join(codes)


def _colour(name: str, base: int) -> list[str]:
    if name == "default":
        return []
    plain = name.removeprefix("bright").replace("yellow", "brown")
    if plain in _COLOURS:
        return [str(_COLOURS.index(plain) + base + 60 * name.startswith("bright"))]
    try:
        red, green, blue = bytes.fromhex(name)
    except ValueError:
        return []
    return [str(base + 8), "2", str(red), str(green), str(blue)]


def shown_again(text: str) -> str:
    """A transcript as a terminal understands it; whatever else a file may hold is left out."""
    lines = "".join(_KEPT.findall(text.replace("\r", ""))).split("\n")
    return "\x1b[0m\r\n".join(lines[-LINES:]) + "\x1b[0m\r\n"
