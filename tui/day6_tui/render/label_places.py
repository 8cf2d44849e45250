"""Where texts stand in a picture of cells: at their points, or close by where another text is in the way, with a leader."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from day6_tui.panes.cells import cell_len
from day6_tui.render.picture import Array, PictureText

ROWS = (0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5)
"""How far a text may be moved down or up, in the order in which that is tried."""

CENTRED, RIGHT, LEFT = range(3)
"""Over its point, or beside it."""

STAYS = 0.75
"""Cells that a point may be away from the middle of a cell it was in: one on an edge would go to and fro."""

LEAST_SHARE = 3
"""A name that is longer than the picture's width divided by this is left out where a robot is seen."""

STAYS_BESIDE = 4
"""Cells that another place beside a robot must be nearer for a name to move there."""

_Span = tuple[int, int] | None

_UNICODE = {"down": "│", "aside": "─", (RIGHT, 1): "╰", (RIGHT, -1): "╭", (LEFT, 1): "╯", (LEFT, -1): "╮"}
_ASCII = {"down": "|", "aside": "-", (RIGHT, 1): "`", (RIGHT, -1): ",", (LEFT, 1): "'", (LEFT, -1): "."}


class LabelPiece(NamedTuple):
    """A text, or a part of its leader: its first cell."""

    column: int
    row: int
    text: str


class Spot(NamedTuple):
    """A way to stand at a point."""

    side: int
    down: int


HOME = Spot(CENTRED, 0)
SPOTS = tuple(Spot(side, down) for side in (CENTRED, RIGHT, LEFT) for down in ROWS)


class _Label(NamedTuple):
    """A text at a point and a spot."""

    x: int
    y: int
    words: str
    spot: Spot


class LabelPlaces:
    """Remembers from picture to picture where each text stood: it keeps its place at its point until it must move.

    It goes home, that is over its point, once there is room to spare. Of texts that say the same, the first is the first again.
    """

    def __init__(self, *, unicode: bool = True) -> None:
        self._signs = _UNICODE if unicode else _ASCII
        self._size = (0, 0)
        self._kept: dict[tuple[str, int], _Label] = {}

    def place(
        self, texts: Sequence[PictureText], columns: int, rows: int, robot: Array | None = None
    ) -> list[list[LabelPiece]]:
        """The pieces of texts that shall stand above the cells (x, y); none of one that there is no room for.

        The earlier text has the better place. A text is centred, or as near to that as the edges allow. Of all rows close by the
        nearest in which it touches no other is taken; if there is none, it stands to the right of its point, or to the left.
        The lines of a text stay together. Where a robot is seen, in the cells `robot`, names stand beside it or are left out.
        """
        if self._size != (columns, rows):
            self._size, self._kept = (columns, rows), {}
        taken = _Taken(columns, rows)
        beside = _spans(robot) if robot is not None and robot.any() else None
        kept: dict[tuple[str, int], _Label] = {}
        found: list[tuple[_Label, list[LabelPiece]] | None] = []
        numbers: Counter[str] = Counter()
        for text in texts:
            key = text.words, numbers[text.words]
            numbers[text.words] += 1
            if text.is_name and beside is not None:
                placed = self._beside(text, self._kept.get(key), taken, beside)
            else:
                placed = self._placed(text.x, text.y, text.words, self._kept.get(key), taken)
            found.append(placed)
            if placed is not None:
                kept[key] = placed[0]
                taken.add(placed[1])
        self._kept = kept
        leaders = [beside is None or not text.is_name for text in texts]
        return [
            [] if each is None else [*each[1], *(self._strokes(each[0], taken) if leads else ())]
            for each, leads in zip(found, leaders, strict=True)
        ]

    def _placed(
        self, x: float, y: float, words: str, before: _Label | None, taken: _Taken
    ) -> tuple[_Label, list[LabelPiece]] | None:
        if words.count("\n") >= taken.rows:
            return None
        column, row = (_steady(x, before.x), _steady(y, before.y)) if before is not None else (int(x), int(y))
        spots = SPOTS
        if before is not None and before.spot != HOME:
            home = self._lines(_Label(column, row, words, HOME), taken)
            if not taken.are_free(home, margin=1):
                spots = (before.spot, *sorted(SPOTS, key=lambda spot: _apart(spot, before.spot)))
        for spot in spots:
            label = _Label(column, row, words, spot)
            lines = self._lines(label, taken)
            if taken.are_free(lines):
                return label, lines
        return None

    def _beside(
        self, text: PictureText, before: _Label | None, taken: _Taken, robot: Sequence[_Span]
    ) -> tuple[_Label, list[LabelPiece]] | None:
        """A name as near to its point as it does not cover the robot; None if there is no room, or it is too long for it."""
        width = cell_len(text.words)
        if width * LEAST_SHARE > taken.columns:
            return None
        x, y = (
            (_steady(text.x, before.x), _steady(text.y, before.y)) if before is not None else (int(text.x), int(text.y))
        )
        best: tuple[float, _Label, list[LabelPiece]] | None = None
        for down in ROWS:
            if best is not None and best[0] <= 2 * abs(down) - STAYS_BESIDE:
                break  # farther than the best already by its row
            for side, start, words in self._ways(x, y + down, down, text.words, taken, robot):
                piece = LabelPiece(start, y + down, words)
                way = abs(start + cell_len(words) / 2 - x) + 2 * abs(down)
                if before is not None and before.spot == (side, down):
                    way -= STAYS_BESIDE
                if (best is None or way < best[0]) and taken.is_free(piece):
                    best = way, _Label(x, y, text.words, Spot(side, down)), [piece]
        return best and (best[1], best[2])

    def _ways(
        self, x: int, row: int, down: int, words: str, taken: _Taken, robot: Sequence[_Span]
    ) -> Iterator[tuple[int, int, str]]:
        """The side, the first cell and the text of a name in a row in which the robot may be."""
        width = cell_len(words)
        if not 0 <= row < taken.rows:
            return
        span, middle = robot[row], max(0, min(x - width // 2, taken.columns - width))
        if span is None or middle >= span[1] or middle + width <= span[0]:
            yield CENTRED, middle, words
        if span is not None:
            hook = self._signs["aside"] if not down else ""
            yield RIGHT, max(span[1], x + 1), hook + words
            yield LEFT, min(span[0], x) - width - len(hook), words + hook

    def _lines(self, label: _Label, taken: _Taken) -> list[LabelPiece]:
        """The lines of a text, and what of its leader is beside the one nearest to the point."""
        x, y, words, (side, down) = label
        lines = words.split("\n")
        top = y + down - (len(lines) - 1 if down < 0 else 0)
        hook = self._hook(side, down)
        pieces = []
        for row, text in enumerate(lines, top):
            width = cell_len(text)
            beside = row == y + down
            if side == CENTRED:
                piece = LabelPiece(max(0, min(x - width // 2, taken.columns - width)), row, text)
            elif side == RIGHT:
                piece = LabelPiece(x + 2 - (len(hook) if beside else 0), row, hook + text if beside else text)
            else:
                piece = LabelPiece(x - 1 - width, row, text + hook if beside else text)
            if text:
                pieces.append(piece)
        return pieces

    def _hook(self, side: int, down: int) -> str:
        """The last part of a leader to the right or to the left."""
        if side == CENTRED:
            return ""
        aside = self._signs["aside"]
        if not down:
            return aside
        corner = self._signs[side, 1 if down > 0 else -1]
        return corner + aside if side == RIGHT else aside + corner

    def _strokes(self, label: _Label, taken: _Taken) -> Iterator[LabelPiece]:
        """The upright part of the leader, where nothing stands."""
        step = 1 if label.spot.down > 0 else -1
        for row in range(label.y + step, label.y + label.spot.down, step):
            stroke = LabelPiece(label.x, row, self._signs["down"])
            if taken.is_free(stroke):
                yield stroke


class _Taken:
    """The cells in which something stands, of `columns` x `rows`."""

    def __init__(self, columns: int, rows: int) -> None:
        self.columns, self.rows = columns, rows
        self._spans: dict[int, list[tuple[int, int]]] = {}

    def add(self, pieces: Sequence[LabelPiece]) -> None:
        for piece in pieces:
            self._spans.setdefault(piece.row, []).append((piece.column, piece.column + cell_len(piece.text)))

    def are_free(self, pieces: Sequence[LabelPiece], margin: int = 0) -> bool:
        """Whether there are pieces, and each is free."""
        return bool(pieces) and all(self.is_free(piece, margin) for piece in pieces)

    def is_free(self, piece: LabelPiece, margin: int = 0) -> bool:
        """Whether it is inside and touches nothing, nor anything in `margin` rows above and below it."""
        left, width = piece.column, cell_len(piece.text)
        if not (width and 0 <= left <= self.columns - width and 0 <= piece.row < self.rows):
            return False
        rows = range(piece.row - margin, piece.row + margin + 1)
        return all(left > end or first > left + width for row in rows for first, end in self._spans.get(row, ()))


def _spans(covered: Array) -> list[_Span]:
    """The first cell of a row that is covered, and the one behind the last."""
    spans: list[_Span] = []
    for row in covered:
        columns = row.nonzero()[0]
        spans.append((int(columns[0]), int(columns[-1]) + 1) if len(columns) else None)
    return spans


def _steady(place: float, before: int) -> int:
    return before if abs(place - before - 0.5) < STAYS else int(place)


def _apart(spot: Spot, before: Spot) -> tuple[bool, int, int]:
    """How far a text jumps from one spot to the other, and how far it is from its point then."""
    return spot.side != before.side, abs(spot.down - before.down), abs(spot.down)
