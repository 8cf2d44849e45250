"""What the terminal shows, cell by cell, so that only what differs is written; and colours, of which only changes are."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache

from rich.cells import cell_len

Span = tuple[int, int, int]
"""Line, first column, end column."""

NEAR = 6
"""Cells that are written again rather than skipped: moving the cursor takes about as much."""
ERASED = 14
"""Blanks that are erased rather than written: erasing them and moving on takes less."""

SEEN_ON_BLANKS = frozenset({"a4", "a7", "a9", "a21", "a51", "a52", "a53"})
"""Attributes that are seen where nothing is written: underlined, reversed, struck out, framed."""

_OFF = {
    "3": "39",
    "4": "49",
    "a1": "22",
    "a2": "22",
    "a3": "23",
    "a4": "24",
    "a5": "25",
    "a7": "27",
    "a8": "28",
    "a9": "29",
    "a53": "55",
}
"""What ends a colour or an attribute."""

_HEADS = {"38": "3", "48": "4"}


def may_erase(environ: Mapping[str, str]) -> bool:
    """Whether a terminal is known to erase cells in the colour it would write them in, as xterm and its relatives do."""
    term = environ.get("TERM", "")
    return term.startswith(("xterm", "rxvt", "alacritty", "foot", "linux")) and "kitty" not in term


class Shown:
    """The cells of the terminal; what is not known of is written whatever comes."""

    def __init__(self) -> None:
        self._rows: dict[int, tuple[list[str | None], list[str | None]]] = {}
        self._size = 0, 0
        self.erases = False
        """Whether the terminal erases cells in the colour it would write them in."""
        self.cursor = -1, -1
        """Column and line of the cursor, -1 where it is not known."""
        self.look: str | None = ""
        """How the terminal shows what is written next; None where that is not known."""

    def begin(self, *, erases: bool) -> None:
        """Another terminal."""
        self.forget()
        self.erases = erases

    def forget(self) -> None:
        """Nothing is known of the terminal any more."""
        self._rows.clear()
        self.cursor, self.look = (-1, -1), None

    def brush(self, width: int, height: int) -> Brush:
        """Return what writes one update of a screen of this size."""
        if (width, height) != self._size:
            self._rows.clear()
            self._size = width, height
        return Brush(self, width)

    def row(self, y: int) -> tuple[list[str | None], list[str | None]]:
        """Characters and looks of a line: '' behind a character of two cells, None where nothing is known."""
        row = self._rows.get(y)
        if row is None:
            row = self._rows[y] = ([None] * self._size[0], [None] * self._size[0])
        return row


class Brush:
    """Writes one update."""

    def __init__(self, shown: Shown, width: int) -> None:
        self._shown = shown
        self._width = width
        self._parts: list[str] = []
        self._x, self._y = shown.cursor
        """Where the cursor is; -1 where that is not certain."""
        self._hurt: list[Span] = []
        self.size = 0
        """Bytes so far."""
        self.drawn: list[Span] = []
        """What was written."""

    def draw(self, x: int, y: int, segments: Iterable[tuple[str, str]]) -> None:
        """Write what differs of a piece of a line: texts and how they look, as the parameters of SGR."""
        chars, looks = self._shown.row(y)
        for text, look in segments:
            if text.isspace():
                look = _ground(look)
            cells = list(text) if text.isascii() else _cells(text)
            end = x + len(cells)
            if end > self._width:
                cells, end = cells[: self._width - x], self._width
            if chars[x:end] != cells or looks[x:end] != [look] * len(cells):
                for first, last in _differences(chars[x:end], looks[x:end], cells, look):
                    self._write(x + first, y, cells[first:last], look)
            x = end
        if not self._parts or not self._parts[-1].isascii():
            self._x = -1  # terminals differ in how wide they take some characters

    def _write(self, x: int, y: int, cells: list[str], look: str) -> None:
        if self._shown.erases and (blank := _blanks_at_end(cells)) >= ERASED and blank < len(cells):
            self._write(x, y, cells[:-blank], look)
            x, cells = x + len(cells) - blank, cells[-blank:]
        chars, looks = self._shown.row(y)
        end = x + len(cells)
        # Of a character that is half overwritten, nothing is left.
        before, after = x, end
        while before and chars[before] == "":
            before -= 1
        while after < self._width and chars[after] == "":
            after += 1
        for spoilt in (*range(before, x), *range(end, after)):
            chars[spoilt] = None
            self._hurt.append((y, spoilt, spoilt + 1))
        chars[x:end], looks[x:end] = cells, [look] * len(cells)
        if self._y != y:
            self._add(f"\x1b[{y + 1};{x + 1}H")
        elif self._x != x:
            self._add(f"\x1b[{x + 1}G")
        present = self._shown.look
        is_blank = _blanks_at_end(cells) == len(cells)
        if is_blank and present is not None:
            look = _for_blanks(present, look)
        if present != look:
            self._add(change(present, look))
        if is_blank and len(cells) >= ERASED and self._shown.erases and not SEEN_ON_BLANKS & _parts(look).keys():
            self._add(f"\x1b[{len(cells)}X")
            end = x  # which does not move the cursor
        else:
            self._add("".join(cells))
        self._shown.look, self._y, self._x = look, y, end if end < self._width else -1
        self.drawn.append((y, x, x + len(cells)))

    def _add(self, text: str) -> None:
        self._parts.append(text)
        self.size += len(text) if text.isascii() else len(text.encode())

    def hurt(self) -> list[Span]:
        """Cells that were spoilt by what was written beside them, and not written since."""
        return [span for span in self._hurt if self._shown.row(span[0])[0][span[1]] is None]

    def text(self) -> str:
        """All of it. The colours stay as they are: what is written next most often has them, too."""
        return "".join(self._parts)


def _blanks_at_end(cells: Sequence[str]) -> int:
    count = len(cells)
    while count and cells[count - 1] == " ":
        count -= 1
    return len(cells) - count


def _differences(
    chars: Sequence[str | None], looks: Sequence[str | None], cells: Sequence[str], look: str
) -> Iterable[tuple[int, int]]:
    """First and end of what differs, without cutting a character."""
    runs: list[list[int]] = []
    for at, cell in enumerate(cells):
        if chars[at] != cell or looks[at] != look:
            if runs and at - runs[-1][1] < NEAR:
                runs[-1][1] = at + 1
            else:
                runs.append([at, at + 1])
    for run in runs:
        while cells[run[0]] == "":
            run[0] -= 1
        while run[1] < len(cells) and cells[run[1]] == "":
            run[1] += 1
    return [(first, end) for first, end in runs]


@lru_cache(maxsize=4096)
def _widths(text: str) -> tuple[str, ...]:
    cells: list[str] = []
    for char in text:
        width = cell_len(char)
        if width:
            cells += [char, *[""] * (width - 1)]
        elif cells:
            head = len(cells) - 1
            while head and cells[head] == "":
                head -= 1
            cells[head] += char
    if len(cells) != (width := cell_len(text)):  # characters that are joined to one
        cells = [text, *[""] * (width - 1)] if width else []
    return tuple(cells)


def _cells(text: str) -> list[str]:
    """What stands in each cell: a character, with its accents; '' in the second cell of a wide one."""
    return list(_widths(text))


@lru_cache(maxsize=4096)
def _ground(look: str) -> str:
    """What is seen of a look on blanks."""
    parts = _parts(look)
    return look if SEEN_ON_BLANKS & parts.keys() else parts.get("4", "")


@lru_cache(maxsize=4096)
def _for_blanks(present: str, look: str) -> str:
    """A look with which blanks are as with `look`, and which is near the present one."""
    ground = _parts(_ground(look))
    if SEEN_ON_BLANKS & ground.keys():
        return look
    kept = {part: value for part, value in _parts(present).items() if part != "4" and part not in SEEN_ON_BLANKS}
    return ";".join({**kept, **ground}.values())


@lru_cache(maxsize=4096)
def change(old: str | None, new: str) -> str:
    """The shortest sequence from one look to another; looks are parameters of SGR, '' the terminal's own, None any."""
    if old == new:
        return ""
    if old is None:
        return f"\x1b[0;{new}m" if new else "\x1b[m"
    before, after = _parts(old), _parts(new)
    ended = [_OFF.get(part, "") for part in before if part not in after]
    if {"a1", "a2"} & after.keys() and "22" in ended:
        ended = [""]  # which would end both bold and dim
    begun = [value for part, value in after.items() if before.get(part) != value]
    whole = f"\x1b[0;{new}m" if new else "\x1b[m"
    return whole if "" in ended else min(f"\x1b[{';'.join([*ended, *begun])}m", whole, key=len)


def _parts(look: str) -> dict[str, str]:
    """What a look consists of: foreground ('3'), background ('4') and each attribute."""
    parts: dict[str, str] = {}
    codes = iter(look.split(";") if look else ())
    for code in codes:
        if code in _HEADS:
            kind = next(codes, "")
            rest = [next(codes, "") for _ in range(3 if kind == "2" else 1)]
            parts[_HEADS[code]] = ";".join([code, kind, *rest])
        elif len(code) > 1 and code[-1] in "01234567" and code[:-1] in ("3", "4", "9", "10"):
            parts["3" if code[:-1] in ("3", "9") else "4"] = code
        elif code in ("39", "49"):
            parts[_HEADS.get(code[0] + "8", "")] = code
        else:
            parts[f"a{code}"] = code
    return parts
