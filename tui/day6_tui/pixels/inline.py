"""Protocols that put pixels where the cursor is and keep nothing: what text overwrote is written again."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable

from day6_tui.pixels.bands import Array, BandPiece


class Inline(ABC):
    """Writes the pieces of a picture each at its place."""

    keeps = False
    """Whether the terminal keeps pictures that only have to be placed again."""

    seams = False
    """Whether pieces do not meet at the edges of cells, so that a picture has to be written whole."""

    @abstractmethod
    def encoded(self, pixels: Array, columns: int, rows: int) -> str:
        """The sequence that draws pixels into so many cells."""

    def draw(self, band: int, pixels: Array, cell: tuple[int, int], pieces: Iterable[BandPiece], changed: bool) -> str:
        """Show the pieces of a band; `cell` is how many of its pixels make a cell."""
        across, down = cell
        texts = []
        for piece in pieces:
            part = pixels[
                piece.top * down : (piece.top + piece.rows) * down,
                piece.left * across : (piece.left + piece.columns) * across,
            ]
            texts.append(f"\x1b[{piece.row + 1};{piece.column + 1}H{self.encoded(part, piece.columns, piece.rows)}")
        return "".join(texts)

    def erase(self, bands: Iterable[int]) -> str:
        """Nothing to do: text that is drawn over a picture erases it."""
        return ""

    def erase_all(self) -> str:
        return ""
