"""A picture of a terminal's screen as SVG: one picture, or a few one after the other.

It looks the same with every font. Blocks, braille, shades and lines are shapes, so that no row of a font's own height tears
them apart; every other piece of text says how wide it is. Shapes of one colour are one path.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from functools import cache
from html import escape
from typing import NamedTuple
from unicodedata import name as name_of

from day6_core.session.harmless import one_line
from day6_core.shell.screen.rows import Style
from day6_core.width import char_width
from day6_tui.cast.film import Rows

CELL = (8, 16)
"""Width and height of a cell: an eighth of its width is a whole number, and so is an eighth of its height."""

SCALE = 1.25
"""Pixels of one unit: 80 columns are as wide as the text of a page on a forge."""

MARGIN = 7
FONT_SIZE = 13.3
"""Most monospaced fonts are 0.6 of it wide."""
WIDE_SIZE = 14.8
"""Of characters that take two cells, which are as wide as they are high."""

FONT = (
    "ui-monospace,SFMono-Regular,Menlo,Consolas,'DejaVu Sans Mono','Liberation Mono','PingFang SC','Microsoft YaHei',"
    "'Noto Sans Mono CJK SC','Noto Sans CJK SC','WenQuanYi Zen Hei',monospace"
)
FOREGROUND, BACKGROUND, FRAME = "#d7dde8", "#12161d", "#3a4350"

_NAMED = {
    "black": "#000000", "red": "#cd3131", "green": "#0dbc79", "brown": "#e5e510", "blue": "#2472c8",
    "magenta": "#bc3fbc", "cyan": "#11a8cd", "white": "#e5e5e5",
    "brightblack": "#666666", "brightred": "#f14c4c", "brightgreen": "#23d18b", "brightbrown": "#f5f543",
    "brightyellow": "#f5f543", "brightblue": "#3b8eea", "brightmagenta": "#d670d6",
    "brightcyan": "#29b8db", "brightwhite": "#ffffff",
}  # fmt: skip
"""The names of `rows.Style`."""

_HEX = frozenset("0123456789abcdef")

Rect = tuple[int, int, int, int]
"""Left, top, width, height."""


class _Text(NamedTuple):
    """A piece of text in one style; `wide` characters take two cells each."""

    x: int
    y: int
    text: str
    cells: int
    wide: bool


class _Part(NamedTuple):
    """Something in a layer: a rectangle, text with `marks` (attributes of SVG), a stroke; without a colour any element."""

    layer: int
    colour: str
    marks: str
    what: Rect | _Text | str


def colour_of(name: str, default: str) -> str:
    """A colour as SVG has it; `default` for the terminal's own and for what isn't a colour."""
    if name in _NAMED:
        return _NAMED[name]
    return f"#{name}" if len(name) == 6 and set(name.lower()) <= _HEX else default


def picture(
    frames: Sequence[Rows],
    size: tuple[int, int],
    seconds: Sequence[float] = (),
    title: str = "",
    over: Sequence[Sequence[str]] = (),
) -> str:
    """The screens, of at most `size` columns and rows, as an SVG text; of several each is seen for so many `seconds`.

    Who wants no motion sees the last of them. `over` has for each what is drawn over its cells: elements in units of `CELL`.
    """
    width, height = (count * cell + 2 * MARGIN for count, cell in zip(size, CELL, strict=True))
    when: defaultdict[_Part, list[int]] = defaultdict(list)
    for index, frame in enumerate(frames):
        parts = [part for y, row in enumerate(frame[: size[1]]) for part in _parts(row, y, size[0])]
        parts += [_Part(3, "", "", element) for element in (over[index] if over else ())]
        for part in dict.fromkeys(parts):
            when[part].append(index)
    shown: defaultdict[int, defaultdict[tuple[int, ...], list[_Part]]] = defaultdict(lambda: defaultdict(list))
    for part, indexes in when.items():
        shown[part.layer][tuple(indexes)].append(part)
    times = [indexes for indexes in dict.fromkeys(map(tuple, when.values())) if len(indexes) < len(frames)]
    classes = {indexes: f' class="t{number}"' for number, indexes in enumerate(times)}
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" viewBox="0 0 {width} {height}" '
        f'width="{width * SCALE:g}" height="{height * SCALE:g}">\n'
        + (f"<title>{escape(one_line(title), quote=False)}</title>\n" if title else "")
        + f"<style>text{{font:{FONT_SIZE}px {FONT};white-space:pre}}.w{{font-size:{WIDE_SIZE}px}}"
        + "".join(_motion(times, seconds))
        + "</style>\n"
        f'<rect x=".5" y=".5" width="{width - 1}" height="{height - 1}" rx="6" fill="{BACKGROUND}" stroke="{FRAME}"/>\n'
        f'<g transform="translate({MARGIN} {MARGIN})">\n'
    )
    groups = [
        f"<g{classes.get(indexes, '')}>\n{''.join(_drawn(parts))}</g>\n"
        for _, layer in sorted(shown.items())
        for indexes, parts in sorted(layer.items())
    ]
    return "".join(['<?xml version="1.0" encoding="UTF-8"?>\n', head, *groups, "</g>\n</svg>\n"])


def _motion(times: Sequence[tuple[int, ...]], seconds: Sequence[float]) -> Iterator[str]:
    """The rules that show and hide what isn't always seen."""
    total, last = sum(seconds), len(seconds) - 1
    for number, indexes in enumerate(times):
        steps, before, at = [], None, 0.0
        for index, each in enumerate(seconds):
            if (seen := index in indexes) is not before:
                steps.append(f"{100 * at / total:.4g}%{{visibility:{'visible' if seen else 'hidden'}}}")
            before, at = seen, at + each
        yield f"\n@keyframes t{number}{{{''.join(steps)}}}\n.t{number}{{animation:t{number} {total:.4g}s step-end infinite"
        yield "}" if last in indexes else ";visibility:hidden}"
    if times:
        yield "\n@media(prefers-reduced-motion:reduce){g{animation:none!important}}"


# -- what is in a row --------------------------------------------------------------------------------------------------


def _parts(row: Sequence[tuple[str, Style]], y: int, columns: int) -> Iterator[_Part]:
    x, top = 0, y * CELL[1]
    for text, style in row:
        front, back = colour_of(style.fg, FOREGROUND), colour_of(style.bg, BACKGROUND)
        if style.reverse:
            front, back = back, front
        marks = ' font-weight="bold"' * style.bold + ' font-style="italic"' * style.italics
        for piece, cells in _pieces(one_line(text)):
            cells = min(cells, columns - x)
            if cells <= 0:
                return
            left, width = x * CELL[0], cells * CELL[0]
            x += cells
            for line in [14] * style.underscore + [8] * style.strikethrough:
                yield _Part(1, front, "", (left, top + line, width, 1))
            if piece in _HALVES:
                for offset, colour in zip((0, 8), (front, back) if piece == "▀" else (back, front), strict=True):
                    if colour != BACKGROUND:
                        yield _Part(0, colour, "", (left, top + offset, width, 8))
                continue
            if piece in _SHADES:
                back = _mixed(front, back, _SHADES.index(piece) + 1)
            if back != BACKGROUND:
                for column in range(left, left + width, CELL[0]):
                    yield _Part(0, back, "", (column, top, CELL[0], CELL[1]))
            if piece in _SHADES:
                continue
            if shape := shape_of(piece):
                for x0, y0, *rest in shape:
                    yield _Part(1, front, "", (left + x0, top + y0, *rest))  # type: ignore[arg-type]
            elif piece in _ARCS:
                yield _Part(1, front, "", f"M{left + _ARCS[piece][0]} {top + _ARCS[piece][1]}{_ARCS[piece][2]}")
            elif seen := piece.rstrip():
                yield _Part(2, front, marks, _Text(left, top + 12, seen, _cells(seen), char_width(seen[0]) == 2))


def _pieces(text: str) -> Iterator[tuple[str, int]]:
    """Text in pieces, each with the cells that it takes: words of ASCII, blanks, wide characters, any other one alone."""
    piece, kind = "", ""
    for char in text:
        width = char_width(char)
        if width == 0:
            piece += char
            continue
        now = "wide" if width == 2 else "" if char > "~" else "blank" if char == " " else "ascii"
        if now == "blank" and kind == "ascii" and piece[-1] != " ":
            piece += char  # one blank between words does not part them
            continue
        if piece and (now != kind or not now):
            yield piece, _cells(piece)
            piece = ""
        piece, kind = piece + char, now
    if piece:
        yield piece, _cells(piece)


def _cells(text: str) -> int:
    return sum(map(char_width, text))


# -- characters that are shapes ----------------------------------------------------------------------------------------

_HALVES = "▀▄"
_SHADES = "░▒▓"
_ARCS = {
    "╭": (3.5, 16, "v-4.5q0-4 4-4h.5"),
    "╮": (0, 7.5, "h.5q3 0 3 4v4.5"),
    "╰": (3.5, 0, "v3.5q0 4 4 4h.5"),
    "╯": (3.5, 0, "v3.5q0 4-3 4h-.5"),
}
_QUADRANTS = {char: bits for bits, char in enumerate(" ▘▝▀▖▌▞▛▗▚▐▜▄▙▟█")}
_DOTS = ((0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (0, 3), (1, 3))
"""Columns and rows of braille's bits."""


@cache
def shape_of(char: str) -> tuple[Rect, ...]:
    """A character as rectangles of its cell; () for one that only a font can draw."""
    code = ord(char) if len(char) == 1 else 0
    if 0x2800 < code <= 0x28FF:
        return tuple((4 * x, 4 * y, 3, 3) for bit, (x, y) in enumerate(_DOTS) if code >> bit & 1)
    if 0x2581 <= code <= 0x2588:
        height = 2 * (code - 0x2580)
        return ((0, 16 - height, 8, height),)
    if 0x2589 <= code <= 0x258F:
        return ((0, 0, 0x2590 - code, 16),)
    if bits := _QUADRANTS.get(char, 0):
        return tuple((4 * (bit % 2), 8 * (bit // 2), 4, 8) for bit in range(4) if bits >> bit & 1)
    return tuple(_line(char)) if 0x2500 <= code < 0x2580 else ()


_ENDS = {"LEFT": "l", "RIGHT": "r", "UP": "u", "DOWN": "d", "HORIZONTAL": "lr", "VERTICAL": "ud"}


def _line(char: str) -> Iterator[Rect]:
    """A character of straight lines, by its Unicode name: "BOX DRAWINGS DOWN LIGHT AND RIGHT HEAVY"."""
    words = name_of(char).split()[2:]
    if not {*words} <= {"LIGHT", "HEAVY", "AND", *_ENDS}:
        return  # dashes, double lines, diagonals
    weight = 0
    for part in " ".join(words).split(" AND "):
        weight = 2 if "HEAVY" in part else 1 if "LIGHT" in part else weight
        for end in "".join(_ENDS.get(word, "") for word in part.split()):
            yield {
                "l": (0, 7, 3 + weight, weight),
                "r": (3, 7, 5, weight),
                "u": (3, 0, weight, 7 + weight),
                "d": (3, 7, weight, 9),
            }[end]


def _mixed(front: str, back: str, quarters: int) -> str:
    """A colour of which so many quarters are `front`."""
    pairs = [(int(front[at : at + 2], 16), int(back[at : at + 2], 16)) for at in (1, 3, 5)]
    return "#" + "".join(f"{(one * quarters + other * (4 - quarters)) // 4:02x}" for one, other in pairs)


# -- as SVG ------------------------------------------------------------------------------------------------------------


def _drawn(parts: Sequence[_Part]) -> Iterator[str]:
    """Parts of one layer and one time; those of one colour together."""
    by_colour: defaultdict[tuple[str, str], list[_Part]] = defaultdict(list)
    for part in parts:
        by_colour[part.colour, part.marks].append(part)
    for (colour, marks), alike in by_colour.items():
        whats = [part.what for part in alike]
        if not colour:
            yield from (what for what in whats if isinstance(what, str))
            continue
        if rects := [what for what in whats if not isinstance(what, (str, _Text))]:
            path = "".join(f"M{x} {y}h{w}v{h}h-{w}z" for x, y, w, h in merged(rects))
            yield f'<path fill="{colour}" shape-rendering="crispEdges" d="{path}"/>\n'
        if strokes := [what for what in whats if isinstance(what, str)]:
            yield f'<path fill="none" stroke="{colour}" d="{"".join(strokes)}"/>\n'
        if texts := [what for what in whats if isinstance(what, _Text)]:
            yield f'<g fill="{colour}"{marks}>{"".join(map(_written, texts))}</g>\n'


def _written(piece: _Text) -> str:
    text = escape(piece.text, quote=False)
    if piece.wide:  # each at its place: a font's are narrower than two cells
        places = " ".join(f"{piece.x + index * 2 * CELL[0] + 0.6:g}" for index in range(piece.cells // 2))
        return f'<text class="w" x="{places}" y="{piece.y + 0.5:g}">{text}</text>'
    length = f' textLength="{piece.cells * CELL[0]}"' if piece.text.isascii() and len(piece.text) > 1 else ""
    if not piece.text.isascii():
        length = f' textLength="{piece.cells * CELL[0]}" lengthAdjust="spacingAndGlyphs"'
    return f'<text x="{piece.x}" y="{piece.y}"{length}>{text}</text>'


def merged(rects: Sequence[Rect]) -> list[Rect]:
    """Fewer rectangles that cover the same: those that meet side by side are one, and then those one below the other."""
    rows: list[Rect] = []
    for x, y, w, h in sorted(rects, key=lambda rect: (rect[1], rect[3], rect[0])):
        if rows and rows[-1][1::2] == (y, h) and (left := rows[-1][0]) + rows[-1][2] >= x:
            rows[-1] = (left, y, max(rows[-1][2], x + w - left), h)
        else:
            rows.append((x, y, w, h))
    whole: list[Rect] = []
    for x, y, w, h in sorted(rows, key=lambda rect: (rect[0], rect[2], rect[1])):
        if whole and whole[-1][::2] == (x, w) and (top := whole[-1][1]) + whole[-1][3] >= y:
            whole[-1] = (x, top, w, max(whole[-1][3], y + h - top))
        else:
            whole.append((x, y, w, h))
    return whole
