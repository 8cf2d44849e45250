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

SEEN_ON_BLANKS = frozenset({"4", "7", "9", "21", "51", "52", "53"})
"""Attributes that are seen where nothing is written: underlined, reversed, struck out, framed."""

_OFF = {"1": "22", "2": "22", "3": "23", "4": "24", "5": "25", "7": "27", "8": "28", "9": "29", "53": "55"}
"""What ends an attribute."""

_COLOURS = {"3": "3", "9": "3", "4": "4", "10": "4"}
"""Foreground or background, by the first digits."""


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
        self._written: list[str] = []
        self._counted = self._size = 0
        self._x, self._y = shown.cursor
        """Where the cursor is; -1 where that is not certain."""
        self._hurt: list[Span] = []
        self.drawn: list[Span] = []
        """What was written."""

    def draw(self, x: int, y: int, segments: Iterable[tuple[str, str]]) -> None:
        """Write what differs of a piece of a line: texts and how they look, as the parameters of SGR."""
        chars, looks = self._shown.row(y)
        is_ascii = True
        for text, look in segments:
            if text.isascii():
                cells = list(text)
                if text.isspace():
                    look = _ground(look)
            else:
                cells, is_ascii = list(_cells(text)), False
            end = x + len(cells)
            if end > self._width:
                cells, end = cells[: self._width - x], self._width
            if end == x + 1:
                if chars[x] != cells[0] or looks[x] != look:
                    self._write(x, y, cells, look)
            elif (seen := chars[x:end]) != cells or looks[x:end].count(look) != end - x:
                for first, last in _differences(seen, looks[x:end], cells, look):
                    self._write(x + first, y, cells[first:last], look)
            x = end
        if not is_ascii:
            self._x = -1  # terminals differ in how wide they take some characters

    def _write(self, x: int, y: int, cells: list[str], look: str) -> None:
        shown, blank = self._shown, 0
        if cells[-1] == " ":
            blank = _blanks_at_end(cells)
            if shown.erases and ERASED <= blank < len(cells):
                self._write(x, y, cells[:-blank], look)
                x, cells = x + len(cells) - blank, cells[-blank:]
        chars, looks = shown.row(y)
        count, end = len(cells), x + len(cells)
        if chars[x] == "" or (end < self._width and chars[end] == ""):
            self._spoil(chars, x, y, end)
        chars[x:end], looks[x:end] = cells, [look] * count
        self.drawn.append((y, x, end))
        place = "" if self._x == x and self._y == y else f"\x1b[{x + 1}G" if self._y == y else f"\x1b[{y + 1};{x + 1}H"
        present, text = shown.look, "".join(cells)
        if blank == count:
            if present is not None:
                look = _for_blanks(present, look)
            if count >= ERASED and shown.erases and not look_on_blanks(look):
                text, end = f"\x1b[{count}X", x  # which does not move the cursor
        self._written.append(f"{place}{text}" if present == look else f"{place}{change(present, look)}{text}")
        shown.look, self._y, self._x = look, y, end if end < self._width else -1

    def _spoil(self, chars: list[str | None], x: int, y: int, end: int) -> None:
        """Of a character that is half overwritten, nothing is left."""
        before, after = x, end
        while before and chars[before] == "":
            before -= 1
        while after < self._width and chars[after] == "":
            after += 1
        for spoilt in (*range(before, x), *range(end, after)):
            chars[spoilt] = None
            self._hurt.append((y, spoilt, spoilt + 1))

    def hurt(self) -> list[Span]:
        """Cells that were spoilt by what was written beside them, and not written since."""
        return [span for span in self._hurt if self._shown.row(span[0])[0][span[1]] is None]

    @property
    def size(self) -> int:
        """Bytes so far."""
        for text in self._written[self._counted :]:
            self._size += len(text) if text.isascii() else len(text.encode())
        self._counted = len(self._written)
        return self._size

    def text(self) -> str:
        """All of it. The colours stay as they are: what is written next most often has them, too."""
        return "".join(self._written)


def _blanks_at_end(cells: Sequence[str]) -> int:
    count = len(cells)
    while count and cells[count - 1] == " ":
        count -= 1
    return len(cells) - count


def _differences(
    chars: Sequence[str | None], looks: Sequence[str | None], cells: Sequence[str], look: str
) -> Iterable[tuple[int, int]]:
    """First and end of what differs, without cutting a character."""
    if len(cells) < NEAR and "" not in cells:
        first, last = 0, len(cells)
        while chars[first] == cells[first] and looks[first] == look:
            first += 1
        while chars[last - 1] == cells[last - 1] and looks[last - 1] == look:
            last -= 1
        return ((first, last),)
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
def _cells(text: str) -> tuple[str, ...]:
    """What stands in each cell: a character, with its accents; '' in the second cell of a wide one."""
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


@lru_cache(maxsize=4096)
def _ground(look: str) -> str:
    """What is seen of a look on blanks."""
    return look if look_on_blanks(look) else _parts(look)[2]


def look_on_blanks(look: str) -> bool:
    """Whether more of a look is seen on blanks than the background."""
    return not SEEN_ON_BLANKS.isdisjoint(_parts(look)[0])


@lru_cache(maxsize=4096)
def _for_blanks(present: str, look: str) -> str:
    """A look with which blanks are as with `look`, and which is near the present one."""
    if look_on_blanks(look):
        return look
    attributes, front, _ = _parts(present)
    return ";".join(
        filter(None, (*(each for each in attributes if each not in SEEN_ON_BLANKS), front, _parts(look)[2]))
    )


@lru_cache(maxsize=4096)
def change(old: str | None, new: str) -> str:
    """The shortest sequence from one look to another; looks are parameters of SGR, '' the terminal's own, None any."""
    if old == new:
        return ""
    whole = f"\x1b[0;{new}m" if new else "\x1b[m"
    if old is None:
        return whole
    (before, front, ground), (after, new_front, new_ground) = _parts(old), _parts(new)
    codes = []
    if before != after:
        ended = {_OFF.get(each, "") for each in before if each not in after}
        if "" in ended or ("22" in ended and ("1" in after or "2" in after)):
            return whole  # 22 ends both bold and dim
        codes += [*ended, *(each for each in after if each not in before)]
    if front != new_front:
        codes.append(new_front or "39")
    if ground != new_ground:
        codes.append(new_ground or "49")
    return min(f"\x1b[{';'.join(codes)}m", whole, key=len)


@lru_cache(maxsize=4096)
def _parts(look: str) -> tuple[tuple[str, ...], str, str]:
    """What a look consists of: attributes, foreground and background, '' for the terminal's own."""
    attributes, colours = [], {"3": "", "4": ""}
    codes = iter(look.split(";") if look else ())
    for code in codes:
        if code in ("38", "48"):
            kind = next(codes, "")
            colours[code[0]] = ";".join([code, kind, *(next(codes, "") for _ in range(3 if kind == "2" else 1))])
        elif len(code) > 1 and code[:-1] in _COLOURS:
            colours[_COLOURS[code[:-1]]] = "" if code in ("39", "49") else code
        else:
            attributes.append(code)
    return tuple(attributes), colours["3"], colours["4"]
