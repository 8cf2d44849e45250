"""Rows, columns and the cells of the edges, once layers and their order are known (Sugiyama's second half)."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from itertools import pairwise

from day6_core.ros.programs.rqt_graph.model.shapes import Cell, Chain, Item, Route, Segment


def grow_for_ports(layers: list[list[Item]], roomy: bool) -> None:
    """Give framed boxes one row for each edge of their busier side, so that edges arrive on rows of their own."""
    if roomy:
        for layer in layers:
            for item in layer:
                if item.box is not None:
                    item.height = max(item.height, len(item.before) + 2, len(item.after) + 2)


def assign_rows(layers: list[list[Item]], gap: int) -> None:
    """Set y of every item, as near to its neighbours as the others of its layer allow."""
    for layer in layers:
        row = 0
        for item in layer:
            item.y = row
            row += item.height + gap
    for sweep in range(6):
        forward = sweep % 2 == 0
        for layer in layers if forward else reversed(layers):
            desired = []
            for item in layer:
                neighbours = (item.before if forward else item.after) or item.before or item.after
                middle = sum(peer.middle for peer in neighbours) / len(neighbours) if neighbours else item.middle
                desired.append(middle - (item.height - 1) / 2)
            for item, row in zip(layer, _nearest_rows(desired, [item.height + gap for item in layer]), strict=True):
                item.y = row
    top = min((item.y for layer in layers for item in layer), default=0)
    for layer in layers:
        for item in layer:
            item.y -= top


def _nearest_rows(desired: list[float], sizes: list[int]) -> list[int]:
    """Return rows as near as possible to the desired ones without overlap (least squares, pool adjacent violators)."""
    blocks: list[tuple[float, int]] = []
    offset = 0
    offsets = []
    for position, size in zip(desired, sizes, strict=True):
        offsets.append(offset)
        mean, count = position - offset, 1
        while blocks and blocks[-1][0] > mean:
            other, others = blocks.pop()
            mean = (mean * count + other * others) / (count + others)
            count += others
        blocks.append((mean, count))
        offset += size
    starts = [round(mean) for mean, count in blocks for _ in range(count)]
    return [start + offset for start, offset in zip(starts, offsets, strict=True)]


def assign_columns(layers: list[list[Item]], chains: list[Chain], margin: int) -> int:
    """Set x of every item and row and track of every segment; return the width of the picture.

    `margin` columns stay free on both sides of each layer.
    """
    between: list[list[Segment]] = [[] for _ in layers]
    for chain in chains:
        chain.segments = [Segment(left, right) for left, right in pairwise(chain.items)]
        for segment in chain.segments:
            between[segment.left.layer].append(segment)
    for segments in between:
        _assign_ports(segments)
    x = margin
    for layer, segments in zip(layers, between, strict=True):
        width = max((item.width for item in layer), default=0)
        for item in layer:
            item.x = x + (width - item.width) // 2
        x += width
        tracks = _assign_tracks(segments)
        for segment in segments:
            segment.track += x + margin + 1
        if segments:
            x += max(4, tracks + 3) + 2 * margin
    return x + margin


def _assign_ports(segments: list[Segment]) -> None:
    """Spread the edges of each side of a box over its rows, in the order of where they lead."""
    leaving: dict[Item, list[Segment]] = {}
    arriving: dict[Item, list[Segment]] = {}
    for segment in segments:
        leaving.setdefault(segment.left, []).append(segment)
        arriving.setdefault(segment.right, []).append(segment)
    for item, group in leaving.items():
        group.sort(key=lambda segment: segment.right.middle)
        for segment, row in zip(group, _port_rows(item, len(group)), strict=True):
            segment.row = row
    for item, group in arriving.items():
        group.sort(key=lambda segment: segment.left.middle)
        for segment, row in zip(group, _port_rows(item, len(group)), strict=True):
            segment.end_row = row


def _port_rows(item: Item, count: int) -> list[int]:
    inner = item.height - 2
    if inner < count:
        return [item.y + item.height // 2] * count
    first = item.y + 1 + (inner - count) // 2
    return [first + index for index in range(count)]


def _assign_tracks(segments: list[Segment]) -> int:
    """Give each bent segment a column of its own where columns would overlap; return the number of columns.

    A segment that leaves on the row on which another arrives must turn before it, else the two would look like one.
    """
    bent = [segment for segment in segments if segment.row != segment.end_row]
    straight = {segment.row for segment in segments if segment.row == segment.end_row}
    leaving: dict[int, list[Segment]] = {}
    for segment in bent:
        leaving.setdefault(segment.row, []).append(segment)
    tracks: list[_Track] = []
    entered: set[Segment] = set()
    done: set[Segment] = set()
    for start in sorted(bent, key=lambda each: (abs(each.row - each.end_row), each.row)):
        # Those before which a segment has to turn come first; where they wait for each other, one has to be.
        waiting = [(start, iter(leaving.get(start.end_row, ())))] if start not in entered else []
        entered.add(start)
        while waiting:
            segment, others = waiting[-1]
            before = next((other for other in others if other not in entered), None)
            if before is not None:
                entered.add(before)
                waiting.append((before, iter(leaving.get(before.end_row, ()))))
                continue
            waiting.pop()
            lowest = max((other.track + 1 for other in leaving.get(segment.end_row, ()) if other in done), default=0)
            low, high = sorted((segment.row, segment.end_row))
            free = (track for track in range(lowest, len(tracks)) if tracks[track].has_room(segment.row, low, high))
            segment.track = next(free, len(tracks))
            if segment.track == len(tracks):
                tracks.append(_Track())
            tracks[segment.track].take(segment.row, low, high)
            done.add(segment)
    return len(tracks) + (1 if straight and tracks else 0)


class _Track:
    """A column between two layers: what of it is taken, from which row to which, by the segments that leave on one row."""

    def __init__(self) -> None:
        self._lows: list[int] = []
        self._spans: list[tuple[int, int]] = []
        """(highest row, row on which they leave), in the order of `_lows`; no two overlap."""

    def has_room(self, row: int, low: int, high: int) -> bool:
        """Whether the rows from `low` to `high` are free, or taken only by segments that leave on the same row."""
        return all(self._spans[at][1] == row for at in self._overlapping(low, high))

    def take(self, row: int, low: int, high: int) -> None:
        """Take rows for a segment that leaves on `row`, for which there is room."""
        for at in reversed(self._overlapping(low, high)):
            low, high = min(low, self._lows.pop(at)), max(high, self._spans.pop(at)[0])
        at = bisect_left(self._lows, low)
        self._lows.insert(at, low)
        self._spans.insert(at, (high, row))

    def _overlapping(self, low: int, high: int) -> range:
        first = bisect_left(self._lows, low)
        if first and self._spans[first - 1][0] >= low:
            first -= 1
        return range(first, bisect_right(self._lows, high))


def route(chain: Chain) -> Route:
    """Return the cells of an edge whose items and segments have their places."""
    cells: list[Cell] = []
    for segment in chain.segments:
        start = segment.left.x + segment.left.width
        stop = segment.right.x - 1
        if segment.row == segment.end_row:
            cells += [(x, segment.row) for x in range(start, stop + 1)]
        else:
            step = 1 if segment.end_row > segment.row else -1
            cells += [(x, segment.row) for x in range(start, segment.track)]
            cells += [(segment.track, y) for y in range(segment.row, segment.end_row, step)]
            cells += [(x, segment.end_row) for x in range(segment.track, stop + 1)]
        if segment.right is chain.label:
            cells += [(segment.right.x + column, segment.right.y) for column in range(segment.right.width)]
    label_at = (chain.label.x, chain.label.y) if chain.label else None
    return Route(chain.edge, tuple(reversed(cells) if chain.reversed else cells), label_at)
