"""A picture of a terminal's screen as SVG: one picture, or a few one after the other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape

from day6_core.session.harmless import one_line
from day6_core.shell.screen.rows import Style
from day6_core.width import char_width
from day6_tui.cast.film import Rows

CELL = (9, 18)
"""Width and height of a cell."""

FONT = "'DejaVu Sans Mono', 'Noto Sans Mono CJK SC', 'Sarasa Mono SC', Menlo, Consolas, monospace"
FOREGROUND, BACKGROUND = "#d7dde8", "#12161d"

_NAMED = {
    "black": "#000000", "red": "#cd3131", "green": "#0dbc79", "brown": "#e5e510", "blue": "#2472c8",
    "magenta": "#bc3fbc", "cyan": "#11a8cd", "white": "#e5e5e5",
    "brightblack": "#666666", "brightred": "#f14c4c", "brightgreen": "#23d18b", "brightbrown": "#f5f543",
    "brightyellow": "#f5f543", "brightblue": "#3b8eea", "brightmagenta": "#d670d6",
    "brightcyan": "#29b8db", "brightwhite": "#ffffff",
}  # fmt: skip
"""The names of `rows.Style`."""

_HEX = frozenset("0123456789abcdef")


def colour_of(name: str, default: str) -> str:
    """A colour as SVG has it; `default` for the terminal's own and for what is none."""
    if name in _NAMED:
        return _NAMED[name]
    return f"#{name}" if len(name) == 6 and set(name.lower()) <= _HEX else default


def picture(frames: Sequence[Rows], size: tuple[int, int], seconds: Sequence[float] = ()) -> str:
    """The screens, of at most `size` columns and rows, as an SVG text; of several each is seen for so many `seconds`."""
    columns, rows = size
    width, height = columns * CELL[0], rows * CELL[1]
    parts = [
        (
            '<?xml version="1.0" encoding="UTF-8"?>\n'
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}">\n'
            f'<rect width="{width}" height="{height}" fill="{BACKGROUND}"/>\n'
            f'<g font-family="{FONT}" font-size="{CELL[1] * 5 // 6}" xml:space="preserve">\n'
        )
    ]
    total, at = sum(seconds), 0.0
    for index, frame in enumerate(frames):
        animated = len(frames) > 1
        parts.append(f'<g visibility="{"hidden" if index else "visible"}">\n' if animated else "<g>\n")
        if animated:
            first, end = at / total, (at + seconds[index]) / total
            at += seconds[index]
            parts.append(_shown_between(first, end, total))
        for y, row in enumerate(frame[:rows]):
            parts += _line(row, y, columns)
        parts.append("</g>\n")
    return "".join([*parts, "</g>\n</svg>\n"])


def _shown_between(first: float, end: float, total: float) -> str:
    times, values = [0.0], ["visible" if first <= 0 else "hidden"]
    for time, value in ((first, "visible"), (end, "hidden")):
        if 0 < time < 1:
            times.append(time)
            values.append(value)
    return (
        f'<animate attributeName="visibility" calcMode="discrete" dur="{total:.2f}s" repeatCount="indefinite" '
        f'keyTimes="{";".join(f"{time:.4f}" for time in times)}" values="{";".join(values)}"/>\n'
    )


def _line(row: Sequence[tuple[str, Style]], y: int, columns: int) -> Iterator[str]:
    x = 0
    for text, style in row:
        front, back = colour_of(style.fg, FOREGROUND), colour_of(style.bg, BACKGROUND)
        if style.reverse:
            front, back = back, front
        for piece, cells in _pieces(one_line(text)):
            cells = min(cells, columns - x)
            if cells <= 0:
                return
            left, top, width = x * CELL[0], y * CELL[1], cells * CELL[0]
            if back != BACKGROUND:
                yield f'<rect x="{left}" y="{top}" width="{width}" height="{CELL[1]}" fill="{back}"/>\n'
            if piece.strip() or style.underscore or style.strikethrough:
                yield (
                    f'<text x="{left}" y="{top + CELL[1] * 3 // 4}" textLength="{width}" lengthAdjust="spacingAndGlyphs" '
                    f'fill="{front}"{_marks(style)}>{escape(piece, quote=False)}</text>\n'
                )
            x += cells


def _pieces(text: str) -> Iterator[tuple[str, int]]:
    """Text in pieces of characters of one width, with the cells that each takes: fonts have other widths than terminals."""
    piece, wide = "", False
    for char in text:
        width = char_width(char)
        if width == 0:
            piece += char
            continue
        if piece and (width == 2) != wide:
            yield piece, _cells(piece)
            piece = ""
        wide = width == 2
        piece += char
    if piece:
        yield piece, _cells(piece)


def _cells(text: str) -> int:
    return sum(map(char_width, text))


def _marks(style: Style) -> str:
    lines = " ".join(["underline"] * style.underscore + ["line-through"] * style.strikethrough)
    return (
        (' font-weight="bold"' if style.bold else "")
        + (' font-style="italic"' if style.italics else "")
        + (f' text-decoration="{lines}"' if lines else "")
    )
