"""The dirty part of a line, and no more.

Textual 8.2 sends a line from the left edge of its widget to the right end of the dirty span, which is about six times the
bytes for everything that moves. Here both ends are cropped; `tests/tui/textual_private/test_dirty_spans.py` compares that cell
by cell.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from day6_tui.panes.cells import cell_len

if TYPE_CHECKING:
    from textual.strip import Strip


def pieces_of_chops(update: Any) -> Iterator[tuple[int, int, Strip]]:
    """The dirty spans alone of a `ChopsUpdate`: column and line of each strip."""
    for y, x1, x2 in update.spans:
        for end, (x, strip) in zip(update.chop_ends[y], update.chops[y].items(), strict=True):
            if strip is None or x >= x2 or end <= x1:
                continue
            left, right = max(x, x1), min(end, x2)
            if left != x or right != end:
                first, last = whole_characters(strip, left - x, right - x)
                left, strip = x + first, strip.crop(first, last)
            yield left, y, strip


def whole_characters(strip: Strip, first: int, last: int) -> tuple[int, int]:
    """Widen a span of cells so that it cuts no character of two cells: drawing half of one erases it.

    An overlay is redrawn wherever the pane below it changes, and neither knows the other's characters.
    """
    column = 0
    for text, _, _ in strip:
        if text.isascii():
            column += len(text)
            continue
        for char in text:
            after = column + cell_len(char)
            if column < first < after:
                first = column
            if column < last < after:
                last = after
            column = after
    return first, last
