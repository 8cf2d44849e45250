"""Text measured in terminal cells: a Chinese character takes two, a combining accent none, a control as many as `^[`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import rich.cells
from rich.cells import set_cell_size
from rich.segment import Segment

from day6_core.session.harmless import one_line

__all__ = ["cell_len", "clip", "fit", "harmless", "wrap"]


def harmless(segments: Iterable[Segment]) -> Iterator[Segment]:
    """Write out every control character: done here, where text becomes cells, and nowhere else."""
    for segment in segments:
        yield segment if segment.text.isprintable() else Segment(one_line(segment.text), segment.style)


def cell_len(text: str) -> int:
    """Cells that `text` takes on the screen, where its control characters are written out."""
    return rich.cells.cell_len(one_line(text))


def clip(text: str, width: int, ellipsis: str = "…") -> str:
    """`text` in at most `width` cells; what does not fit is replaced by the ellipsis."""
    if width <= 0:
        return ""
    text = one_line(text)
    if cell_len(text) <= width:
        return text
    if width <= cell_len(ellipsis):
        return set_cell_size(text, width).rstrip()
    return set_cell_size(text, width - cell_len(ellipsis)).rstrip() + ellipsis


def fit(text: str, width: int, ellipsis: str = "…") -> str:
    """`text` in exactly `width` cells, clipped or padded on the right."""
    return set_cell_size(clip(text, width, ellipsis), max(0, width))


def wrap(text: str, width: int) -> list[str]:
    """Break `text` into lines of at most `width` cells: between words, and anywhere between Chinese characters."""
    width = max(2, width)
    lines: list[str] = []
    for paragraph in map(one_line, text.split("\n")):
        if cell_len(paragraph) <= width:
            lines.append(paragraph.rstrip())
            continue
        line, used = "", 0
        for word in _words(paragraph):
            size = cell_len(word)
            if used + size > width and line:
                lines.append(line.rstrip())
                line, used = "", 0
                word = word.lstrip()
                size = cell_len(word)
            while size > width:
                head = _head(set_cell_size(word, width).rstrip())
                lines.append(head)
                word = word[len(head) :]
                size = cell_len(word)
            line += word
            used += size
        lines.append(line.rstrip())
    return lines


_GOES_ON = ("/", "_-.:=,")
"""Signs at the end of a line that say that a path or name goes on below, without a blank: the best first."""


def _head(text: str) -> str:
    """What to show of a word before a break: up to a sign that shows the break to be none of the word's own."""
    for signs in _GOES_ON:
        if (end := max(text.rfind(sign) for sign in signs) + 1) > len(text) // 2:
            return text[:end]
    return text


_NO_LINE_START = set("，。、；：！？）》」』”’…")
_NO_LINE_END = set("（《「『“‘")


def _words(text: str) -> list[str]:
    """Pieces that must not be broken: words with the space after them, single wide characters with closing marks."""
    pieces: list[str] = []
    word = ""
    for char in text:
        if char in _NO_LINE_START and (word or pieces):
            if word:
                word += char
            else:
                pieces[-1] += char
        elif char in _NO_LINE_END:
            if word:
                pieces.append(word)
            word = char
        elif cell_len(char) == 2:
            if word and word[-1] not in _NO_LINE_END:
                pieces.append(word)
                word = ""
            pieces.append(word + char)
            word = ""
        elif char == " ":
            pieces.append(word + " ")
            word = ""
        else:
            word += char
    if word:
        pieces.append(word)
    return pieces
