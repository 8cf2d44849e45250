"""The two lines above and below the desktop: what runs, and which keys work now."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

from rich.segment import Segment
from rich.style import Style

from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip
from day6_tui.panes.pane import Pane, Piece

Source = Callable[[int], tuple[Sequence[Piece], Sequence[Piece]]]
"""Returns the pieces at the left and at the right end, for a width in cells."""


class Bar(Pane, can_focus=False):
    """One line with pieces at the left and at the right end; if it is narrow, the last left ones are dropped first."""

    DEFAULT_CSS = "Bar { height: 1; }"
    framed = False

    def __init__(self, look: Look, source: Source, *, name: str) -> None:
        super().__init__(look, id=name)
        self._source = source
        self._shown: tuple[Sequence[Piece], Sequence[Piece]] | None = None

    @property
    def background(self) -> Style:
        return self.look.colours.bar

    def restyle(self) -> None:
        self._shown = None
        super().restyle()

    def pull(self, now: float) -> bool:
        pieces = self._source(self.extent.width)
        if pieces != self._shown:
            self._shown = pieces
            self.touch_lines([0])
        return False

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        self._hits.clear()
        left, right = self._shown or self._source(self.extent.width)
        right_width = sum(cell_len(piece.text) for piece in right)
        if right_width > width // 2:
            right, right_width = right[-1:], sum(cell_len(piece.text) for piece in right[-1:])
        if right_width > width:
            right, right_width = (), 0
        x = 0
        room = width - right_width
        for piece in left:
            size = cell_len(piece.text)
            if x + size > room:
                text = clip(piece.text, room - x, self.look.glyphs.ellipsis) if piece is left[0] else ""
                if len(text) > 3:
                    yield Segment(text, piece.style)
                    x += cell_len(text)
                break
            yield self._place(y, x, piece)
            x += size
        yield Segment(" " * (room - x), self.background)
        x = room
        for piece in right:
            yield self._place(y, x, piece)
            x += cell_len(piece.text)

    def _place(self, y: int, x: int, piece: Piece) -> Segment:
        if piece.action is not None:
            self.add_hit(y, x, x + cell_len(piece.text), piece.action)
        return Segment(piece.text, piece.style)


class KeyHint(NamedTuple):
    """A key for the key bar. The last of those with the lowest weight is dropped first when there is too little room."""

    key: str
    name: str
    action: Callable[[], object] | None = None
    weight: int = 9


def key_pieces(look: Look, keys: Sequence[KeyHint], width: int) -> list[Piece]:
    """Keys as the key bar shows them: the key in a box, what it does beside it; as many as fit into `width` cells."""
    kept = list(keys)
    roomy, tight = (" {} ", " {}  "), ("{}", " {} ")
    for key_format, name_format in (roomy, tight):
        pieces = _key_pieces(look, kept, key_format, name_format)
        if _width(pieces) <= width:
            return pieces
    while len(kept) > 1:
        kept.remove(min(reversed(kept), key=lambda hint: hint.weight))
        pieces = _key_pieces(look, kept, *tight)
        if _width(pieces) <= width:
            break
    return pieces


def _width(pieces: Sequence[Piece]) -> int:
    return sum(cell_len(piece.text) for piece in pieces)


def _key_pieces(look: Look, keys: Sequence[KeyHint], key_format: str, name_format: str) -> list[Piece]:
    pieces = []
    for key, name, action, _ in keys:
        pieces.append(Piece(key_format.format(key), look.colours.key, action))
        pieces.append(Piece(name_format.format(name), look.colours.bar, action))
    return pieces
