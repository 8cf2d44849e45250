"""Layered drawing of a directed graph in terminal cells, left to right.

The method of Sugiyama: break cycles, put boxes into layers, order each layer so that few edges cross, give every item
a row, then route the edges along rows and through vertical tracks between the layers. An edge with a label is split by
its label, which is an item like a box, so labels never lie on anything else. An edge that runs against the direction
keeps its place and carries its arrow at the left end.

Pure: knows nothing of ROS. Coordinates are cells, x to the right, y down.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise

Cell = tuple[int, int]


@dataclass(frozen=True)
class Box:
    """Something to draw: `lines` of text in a frame of some `shape`."""

    key: str
    lines: tuple[str, ...]
    shape: str


@dataclass(frozen=True)
class Edge:
    """An arrow between two boxes; `label` may be empty. `key` names what flows along it (the topic).

    Where arrows go both ways, those of the greater `weight` decide what lies left.
    """

    start: str
    end: str
    label: str
    key: str
    weight: float = 1.0


@dataclass(frozen=True)
class Rect:
    """Where a box lies: left column, top row, width and height in cells."""

    x: int
    y: int
    width: int
    height: int


@dataclass(frozen=True)
class Route:
    """The cells of one edge from its start to its end, and where its label begins (None without one)."""

    edge: Edge
    cells: tuple[Cell, ...]
    label_at: Cell | None


@dataclass(frozen=True)
class Picture:
    """A finished layout."""

    width: int
    height: int
    boxes: dict[str, tuple[Box, Rect]]
    routes: tuple[Route, ...]


@dataclass(eq=False)
class _Item:
    """A box, a label or a bend of a long edge."""

    width: int
    height: int
    box: Box | None = None
    layer: int = 0
    x: int = 0
    y: int = 0
    before: list[_Item] = field(default_factory=list)
    after: list[_Item] = field(default_factory=list)

    @property
    def middle(self) -> float:
        return self.y + (self.height - 1) / 2


@dataclass(eq=False)
class _Segment:
    """One piece of an edge between two neighbouring layers."""

    left: _Item
    right: _Item
    row: int = 0
    end_row: int = 0
    track: int = 0


@dataclass(eq=False)
class _Chain:
    """An edge as a path of items; `reversed` when it was turned round to break a cycle."""

    edge: Edge
    items: list[_Item]
    reversed: bool
    label: _Item | None
    segments: list[_Segment] = field(default_factory=list)


def layout(boxes: list[Box], edges: list[Edge], measure: Callable[[str], int], *, roomy: bool = True) -> Picture:
    """Place boxes and edges.

    `measure` gives the width of a text in cells. With `roomy` boxes have a frame above and below (3 rows for one line),
    else each takes a single row. Edges whose ends are missing are an error (KeyError); self-loops are not drawn.
    """
    items = {box.key: _box_item(box, measure, roomy) for box in boxes}
    edges = [edge for edge in edges if edge.start != edge.end]
    backward = _backward_edges([box.key for box in boxes], edges)
    chains = [_chain(edge, items, edge in backward, measure) for edge in edges]
    everything = [*items.values(), *(chain.label for chain in chains if chain.label is not None)]
    _assign_layers(everything, chains)
    layers = _fill_layers(everything, chains)
    for chain in chains:
        for left, right in pairwise(chain.items):
            left.after.append(right)
            right.before.append(left)
    _order(layers)
    _grow_for_ports(layers, roomy)
    _assign_rows(layers, gap=1 if roomy else 0)
    width = _assign_columns(layers, chains)
    height = max((item.y + item.height for layer in layers for item in layer), default=0)
    placed = {
        item.box.key: (item.box, Rect(item.x, item.y, item.width, item.height)) for item in items.values() if item.box
    }
    return Picture(width, height, placed, tuple(_route(chain, layers) for chain in chains))


def _box_item(box: Box, measure: Callable[[str], int], roomy: bool) -> _Item:
    lines = box.lines if roomy else box.lines[:1]
    return _Item(max(measure(line) for line in lines) + 4, len(lines) + 2 if roomy else 1, box)


def _backward_edges(keys: list[str], edges: list[Edge]) -> set[Edge]:
    """Return the edges whose reversal leaves no cycle: those that close one in a depth-first walk from the sources."""
    targets: dict[str, list[Edge]] = {key: [] for key in keys}
    inflow = dict.fromkeys(keys, 0.0)
    outflow = dict.fromkeys(keys, 0.0)
    for edge in edges:
        targets[edge.start].append(edge)
        inflow[edge.end] += edge.weight
        outflow[edge.start] += edge.weight
    state: dict[str, int] = {}
    backward: set[Edge] = set()
    for root in sorted(keys, key=lambda key: (inflow[key] > 0, inflow[key] - outflow[key])):
        if root in state:
            continue
        state[root] = 1
        stack = [(root, iter(targets[root]))]
        while stack:
            key, rest = stack[-1]
            following = next(rest, None)
            if following is None:
                state[key] = 2
                stack.pop()
            elif state.get(following.end) == 1:
                backward.add(following)
            elif following.end not in state:
                state[following.end] = 1
                stack.append((following.end, iter(targets[following.end])))
    return backward


def _chain(edge: Edge, items: dict[str, _Item], turned: bool, measure: Callable[[str], int]) -> _Chain:
    start, end = items[edge.start], items[edge.end]
    if turned:
        start, end = end, start
    label = _Item(measure(edge.label), 1) if edge.label else None
    return _Chain(edge, [start, label, end] if label else [start, end], turned, label)


def _assign_layers(items: list[_Item], chains: list[_Chain]) -> None:
    """Longest path from the left; then sources move right, next to what they feed."""
    after: dict[_Item, list[_Item]] = {item: [] for item in items}
    waiting = dict.fromkeys(items, 0)
    for chain in chains:
        for left, right in pairwise(chain.items):
            after[left].append(right)
            waiting[right] += 1
    sources = [item for item in items if waiting[item] == 0]
    ready = list(sources)
    while ready:
        item = ready.pop()
        for follower in after[item]:
            follower.layer = max(follower.layer, item.layer + 1)
            waiting[follower] -= 1
            if waiting[follower] == 0:
                ready.append(follower)
    for item in sources:
        if after[item]:
            item.layer = min(follower.layer for follower in after[item]) - 1


def _fill_layers(items: list[_Item], chains: list[_Chain]) -> list[list[_Item]]:
    """Return the layers, with a bend wherever an edge passes through one."""
    layers: list[list[_Item]] = [[] for _ in range(max((item.layer for item in items), default=-1) + 1)]
    for item in items:
        layers[item.layer].append(item)
    for chain in chains:
        full = [chain.items[0]]
        for right in chain.items[1:]:
            for layer in range(full[-1].layer + 1, right.layer):
                bend = _Item(0, 1, layer=layer)
                layers[layer].append(bend)
                full.append(bend)
            full.append(right)
        chain.items = full
    return layers


def _order(layers: list[list[_Item]]) -> None:
    """Sort every layer by the mean place of its neighbours, to and fro; keep the order with the fewest crossings."""
    best = [list(layer) for layer in layers]
    fewest = _crossings(layers)
    for sweep in range(8):
        forward = sweep % 2 == 0
        for layer in layers if forward else reversed(layers):
            place = {item: float(index) for index, item in enumerate(layer)}
            for item in layer:
                neighbours = item.before if forward else item.after
                if neighbours:
                    peers = layers[neighbours[0].layer]
                    place[item] = sum(peers.index(peer) for peer in neighbours) / len(neighbours)
            layer.sort(key=place.__getitem__)
        crossings = _crossings(layers)
        if crossings < fewest:
            fewest, best = crossings, [list(layer) for layer in layers]
        if fewest == 0:
            break
    for layer, order in zip(layers, best, strict=True):
        layer[:] = order


def _crossings(layers: list[list[_Item]]) -> int:
    total = 0
    for left, right in pairwise(layers):
        place = {item: index for index, item in enumerate(right)}
        seen: list[int] = []
        for item in left:
            ends = sorted(place[follower] for follower in item.after)
            total += sum(1 for end in ends for earlier in seen if earlier > end)
            seen += ends
    return total


def _grow_for_ports(layers: list[list[_Item]], roomy: bool) -> None:
    """Give framed boxes one row for each edge of their busier side, so that edges arrive on rows of their own."""
    if roomy:
        for layer in layers:
            for item in layer:
                if item.box is not None:
                    item.height = max(item.height, len(item.before) + 2, len(item.after) + 2)


def _assign_rows(layers: list[list[_Item]], gap: int) -> None:
    for layer in layers:
        row = 0
        for item in layer:
            item.y = row
            row += item.height + gap
    for sweep in range(6):
        forward = sweep % 2 == 0
        for layer in layers if forward else reversed(layers):
            wished = []
            for item in layer:
                neighbours = (item.before if forward else item.after) or item.before or item.after
                middle = sum(peer.middle for peer in neighbours) / len(neighbours) if neighbours else item.middle
                wished.append(middle - (item.height - 1) / 2)
            for item, row in zip(layer, _nearest_rows(wished, [item.height + gap for item in layer]), strict=True):
                item.y = row
    top = min((item.y for layer in layers for item in layer), default=0)
    for layer in layers:
        for item in layer:
            item.y -= top


def _nearest_rows(wished: list[float], sizes: list[int]) -> list[int]:
    """Return rows as near as possible to the wished ones without overlap (least squares, pool adjacent violators)."""
    blocks: list[tuple[float, int]] = []
    offset = 0
    offsets = []
    for wish, size in zip(wished, sizes, strict=True):
        offsets.append(offset)
        mean, count = wish - offset, 1
        while blocks and blocks[-1][0] > mean:
            other, others = blocks.pop()
            mean = (mean * count + other * others) / (count + others)
            count += others
        blocks.append((mean, count))
        offset += size
    starts = [round(mean) for mean, count in blocks for _ in range(count)]
    return [start + offset for start, offset in zip(starts, offsets, strict=True)]


def _assign_columns(layers: list[list[_Item]], chains: list[_Chain]) -> int:
    """Set x of every item and row and track of every segment; return the width of the picture."""
    between: list[list[_Segment]] = [[] for _ in layers]
    for chain in chains:
        chain.segments = [_Segment(left, right) for left, right in pairwise(chain.items)]
        for segment in chain.segments:
            between[segment.left.layer].append(segment)
    for segments in between:
        _assign_ports(segments)
    x = 0
    for layer, segments in zip(layers, between, strict=True):
        width = max((item.width for item in layer), default=0)
        for item in layer:
            item.x = x + (width - item.width) // 2
        x += width
        tracks = _assign_tracks(segments)
        for segment in segments:
            segment.track += x + 1
        if segments:
            x += max(4, tracks + 3)
    return x


def _assign_ports(segments: list[_Segment]) -> None:
    """Spread the edges of each side of a box over its rows, in the order of where they lead."""
    leaving: dict[_Item, list[_Segment]] = {}
    arriving: dict[_Item, list[_Segment]] = {}
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


def _port_rows(item: _Item, count: int) -> list[int]:
    inner = item.height - 2
    if inner < count:
        return [item.y + item.height // 2] * count
    first = item.y + 1 + (inner - count) // 2
    return [first + index for index in range(count)]


def _assign_tracks(segments: list[_Segment]) -> int:
    """Give each bent segment a column of its own where columns would overlap; return the number of columns.

    A segment that leaves on the row on which another arrives must turn before it, else the two would look like one.
    """
    bent = [segment for segment in segments if segment.row != segment.end_row]
    straight = {segment.row for segment in segments if segment.row == segment.end_row}
    first: dict[_Segment, list[_Segment]] = {
        segment: [other for other in bent if other is not segment and other.row == segment.end_row] for segment in bent
    }
    taken: list[list[_Segment]] = []
    done: set[_Segment] = set()

    def place(segment: _Segment, path: tuple[_Segment, ...]) -> None:
        if segment in done or segment in path:
            return
        for other in first[segment]:
            place(other, (*path, segment))
        lowest = max((other.track + 1 for other in first[segment] if other in done), default=0)
        low, high = sorted((segment.row, segment.end_row))
        for track in range(lowest, len(taken) + 1):
            if track == len(taken):
                taken.append([])
            together = taken[track]
            if all(_apart(low, high, other) or other.row == segment.row for other in together):
                together.append(segment)
                segment.track = track
                break
        done.add(segment)

    for segment in sorted(bent, key=lambda each: (abs(each.row - each.end_row), each.row)):
        place(segment, ())
    return len(taken) + (1 if straight and taken else 0)


def _apart(low: int, high: int, other: _Segment) -> bool:
    other_low, other_high = sorted((other.row, other.end_row))
    return high < other_low or other_high < low


def _route(chain: _Chain, layers: list[list[_Item]]) -> Route:
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
