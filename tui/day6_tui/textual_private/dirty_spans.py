"""Makes Textual send only the dirty part of a line.

`ChopsUpdate.render_segments` of Textual 8.2 sends a line from the left edge of its widget to the right end of the dirty
span, which is about six times the bytes for everything that moves. The corrected method crops both ends;
`tests/tui/textual_private/test_dirty_spans.py` compares it cell by cell with the original.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_tui.panes.cells import cell_len

if TYPE_CHECKING:
    from textual.strip import Strip


def render_segments(self: Any, console: Any) -> str:
    """As `ChopsUpdate.render_segments`, for the dirty spans alone."""
    sequences: list[str] = []
    append = sequences.append
    chops = self.chops
    chop_ends = self.chop_ends
    for y, x1, x2 in self.spans:
        for end, (x, strip) in zip(chop_ends[y], chops[y].items(), strict=True):
            if strip is None or x >= x2 or end <= x1:
                continue
            left, right = max(x, x1), min(end, x2)
            if left != x or right != end:
                first, last = whole_characters(strip, left - x, right - x)
                left, strip = x + first, strip.crop(first, last)
            append(f"\x1b[{y + 1};{left + 1}H")
            append(strip.render(console))
    return "".join(sequences)


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


def install() -> None:
    """Replace the method."""
    from textual._compositor import ChopsUpdate

    ChopsUpdate.render_segments = render_segments  # type: ignore[method-assign]
