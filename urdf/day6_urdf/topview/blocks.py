"""A robot drawn with few, large dots: half blocks, whole cells, or the lines of braille characters.

Everything is snapped to whole dots. Averaging a finer picture instead would leave a smear of it: at this size a wheel is three
dots thick and its mark two dots wide.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import groupby, pairwise
from operator import itemgetter

from day6_urdf.topview.canvas import Row, visible_part
from day6_urdf.topview.frame import Spot, TopFrame

DOTS = {"half": (1, 2), "cell": (1, 1), "braille": (2, 4)}
"""Dots across and down in one cell, by set of glyphs."""

_BRAILLE = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
Spans = dict[int, tuple[int, int]]
"""From and to, by row of dots."""

_THIN = 5
"""Dots below which a shape has no room for an edge."""


class Blocks:
    """The dots of a picture, 0xRRGGBB or -1 for background. It is the `Painter` of half blocks and whole cells."""

    def __init__(self, frame: TopFrame, background: int) -> None:
        self.frame = frame
        self.background = background
        self.lines = [[background] * frame.width for _ in range(frame.height)]

    # -- painting ------------------------------------------------------------------------------------------------------

    def polygon(self, points: Sequence[Spot], fill: int, edge: int = -1) -> None:
        """Fill a convex polygon; an edge is one dot wide, and missing where the shape is too thin for it."""
        self._fill(self._spans(points), fill, edge)

    def disc(self, spot: Spot, radius: float, fill: int, edge: int = -1) -> None:
        """Fill a circle, at least one dot of it."""
        # Its middle lies on or between dots, so that it is alike on all sides.
        x, _ = self.frame.place(spot)
        _, y = self.frame.snapped(spot)
        across, down = max(round(2 * radius * self.frame.metre) / 2, 0.5), max(round(radius * self.frame.down), 1)
        x = math.floor(x - across + 0.5) + across
        spans: Spans = {}
        for row in range(max(y - down, -2), min(y + down, self.frame.height + 2)):
            half = across * math.sqrt(max(0.0, 1 - ((row + 0.5 - y) / down) ** 2))
            start, end = math.floor(x - half + 0.5), math.ceil(x + half - 0.5)
            if start < end:
                spans[row] = start, end
        self._fill(spans, fill, edge)

    def _spans(self, points: Sequence[Spot]) -> Spans:
        """Where each row of dots is inside a convex polygon."""
        box = self._box(points)
        if box is None:
            return _spans([self.frame.place(point) for point in points], self.frame.height)
        left, top, right, bottom = box
        return dict.fromkeys(range(max(top, -2), min(bottom, self.frame.height + 2)), (left, right))

    def _box(self, points: Sequence[Spot]) -> tuple[int, int, int, int] | None:
        """The sides of an upright box between dots, at least one dot wide and high; None for another polygon."""
        xs, ys = {round(x, 9) for x, _ in points}, {round(y, 9) for _, y in points}
        if len(xs) > 2 or len(ys) > 2:
            return None
        low, high = (min(xs), min(ys)), (max(xs), max(ys))
        left, bottom = self.frame.snapped(low)
        right, top = self.frame.snapped(high)
        if right == left:
            left = math.floor(self.frame.place(low)[0])
            right = left + 1
        if top == bottom:
            top = math.floor(self.frame.place(high)[1])
            bottom = top + 1
        return left, top, right, bottom

    def _fill(self, spans: Spans, fill: int, edge: int) -> None:
        if not spans:
            return
        thin = len(spans) < _THIN or max(end - start for start, end in spans.values()) < _THIN
        for row, (start, end) in spans.items():
            if edge < 0 or thin:
                self._run(row, start, end, fill)
                continue
            self._run(row, start, end, edge)
            above, below = spans.get(row - 1), spans.get(row + 1)
            if above is not None and below is not None:
                self._run(row, max(start + 1, above[0], below[0]), min(end - 1, above[1], below[1]), fill)

    def _run(self, row: int, start: int, end: int, colour: int) -> None:
        start, end = max(start, 0), min(end, self.frame.width)
        if 0 <= row < self.frame.height and start < end:
            self.lines[row][start:end] = [colour] * (end - start)

    # -- rows of cells -------------------------------------------------------------------------------------------------

    def rows(self) -> list[Row]:
        """The rows of cells; a run's style is the colours of its characters and of what is behind them."""
        down = self.frame.dots[1]
        groups = [self.lines[row : row + down] for row in range(0, len(self.lines), down)]
        make = {1: _cells, 2: _halves, 4: self._dots}[down]
        return [make(group) for group in groups]

    def _dots(self, lines: list[list[int]]) -> Row:
        ground = self.background
        cells: dict[int, tuple[int, int]] = {}
        for number, line in enumerate(lines):
            for x, colour in [(x, colour) for x, colour in enumerate(line) if colour != ground]:
                bits, before = cells.get(x // 2, (0, -1))
                cells[x // 2] = bits | _BRAILLE[number][x % 2], max(before, colour)
        row = [cells.get(column, (0, -1)) for column in range(self.frame.columns)]
        return [
            ("".join(chr(0x2800 + bits) if bits else " " for bits, _ in run), (colour, ground))
            for colour, run in groupby(row, itemgetter(1))
        ]

    def ground(self, column: int, row: int) -> int:
        """The colour behind a cell's character."""
        across, down = self.frame.dots
        return self.lines[row * down + down // 2][column * across]


class Lines(Blocks):
    """The `Painter` of braille characters: shapes with an edge are outlines, those without are filled."""

    def polygon(self, points: Sequence[Spot], fill: int, edge: int = -1) -> None:
        """Draw the outline of a convex polygon in the colour of its edge, or fill it."""
        if edge < 0:
            super().polygon(points, fill)
            return
        box = self._box(points)
        if box is not None:  # its last dots lie before its right and lower sides
            left, top, right, bottom = box
            corners: list[Spot] = [(left, top), (right - 1, top), (right - 1, bottom - 1), (left, bottom - 1)]
        else:
            corners = [self.frame.place(point) for point in points]
        self._fill(self._spans(points), self.background, -1)
        for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
            self._line(start, end, edge)

    def disc(self, spot: Spot, radius: float, fill: int, edge: int = -1) -> None:
        """Draw a circle."""
        x, y = self.frame.place(spot)
        across, down = max(radius * self.frame.metre, 0.5), max(radius * self.frame.down, 0.5)
        turns = [2 * math.pi * step / 24 for step in range(25)]
        rim = [(x + across * math.cos(turn), y + down * math.sin(turn)) for turn in turns]
        self._fill(_spans(rim, self.frame.height), self.background, -1)
        for start, end in pairwise(rim):
            self._line(start, end, fill if edge < 0 else edge)

    def _line(self, start: Spot, end: Spot, colour: int) -> None:
        part = visible_part(start, end, self.frame.width, self.frame.height)
        if part is None:
            return
        way = end[0] - start[0], end[1] - start[1]
        start, end = ((start[0] + way[0] * share, start[1] + way[1] * share) for share in part)
        steps = max(1, math.ceil(max(abs(end[0] - start[0]), abs(end[1] - start[1]))))
        for step in range(steps + 1):
            share = step / steps
            column = math.floor(start[0] + (end[0] - start[0]) * share)
            self._run(math.floor(start[1] + (end[1] - start[1]) * share), column, column + 1, colour)


def _halves(lines: list[list[int]]) -> Row:
    runs: Row = []
    for (top, bottom), run in groupby(zip(*lines, strict=True)):
        count = len(list(run))
        runs.append((" " * count, (-1, top)) if top == bottom else ("▀" * count, (top, bottom)))
    return runs


def _cells(lines: list[list[int]]) -> Row:
    return [(" " * len(list(run)), (-1, colour)) for colour, run in groupby(lines[0])]


def _spans(corners: Sequence[Spot], height: int) -> Spans:
    """Where each row of dots is inside a convex polygon: a dot is if its middle is, and in a thin one at least one of a row."""
    top, bottom = min(y for _, y in corners), max(y for _, y in corners)
    first, last = math.floor(top + 0.5), math.ceil(bottom - 0.5)
    if first >= last:
        first = math.floor((top + bottom) / 2)
        last = first + 1
    first, last = max(first, -2), min(last, height + 2)  # one more than is seen, for the edges
    sides = list(zip(corners, [*corners[1:], corners[0]], strict=True))
    spans: Spans = {}
    for row in range(first, last):
        y = min(max(row + 0.5, top), bottom)
        cuts = []
        for (ax, ay), (bx, by) in sides:
            if ay == by:
                if ay == y:
                    cuts += [ax, bx]
            elif min(ay, by) <= y <= max(ay, by):
                cuts.append(ax + (bx - ax) * (y - ay) / (by - ay))
        if cuts:
            start, end = math.floor(min(cuts) + 0.5), math.ceil(max(cuts) - 0.5)
            if start >= end:
                start = math.floor((min(cuts) + max(cuts)) / 2)
                end = start + 1
            spans[row] = start, end
    return spans
