"""Text measured in terminal cells: a Chinese character takes two, a combining accent none, a control as many as `^[`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import rich.cells
from rich.cells import set_cell_size
from rich.segment import Segment

from day6_core import wrapping
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
    return wrapping.wrap("\n".join(map(one_line, text.split("\n"))), width, rich.cells.cell_len)
