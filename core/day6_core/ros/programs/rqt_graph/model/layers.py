"""Which column a box goes to and in which order a column stands, so that few edges cross (Sugiyama's first half)."""

from __future__ import annotations

from bisect import bisect_right, insort
from collections.abc import Callable
from itertools import pairwise

from day6_core.ros.programs.rqt_graph.model.shapes import Chain, Edge, Item, common


def backward_edges(keys: list[str], edges: list[Edge]) -> set[Edge]:
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


def make_chain(edge: Edge, items: dict[str, Item], turned: bool, measure: Callable[[str], int]) -> Chain:
    """Return an edge as start, label if it has one, and end; the other way round if it was turned."""
    start, end = items[edge.start], items[edge.end]
    if turned:
        start, end = end, start
    label = Item(measure(edge.label), 1, cluster=common(start.cluster, end.cluster)) if edge.label else None
    return Chain(edge, [start, label, end] if label else [start, end], turned, label)


def assign_layers(items: list[Item], chains: list[Chain]) -> None:
    """Longest path from the left; then sources move right, next to what they feed."""
    after: dict[Item, list[Item]] = {item: [] for item in items}
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


def fill_layers(items: list[Item], chains: list[Chain]) -> list[list[Item]]:
    """Return the layers, with a bend wherever an edge passes through one."""
    layers: list[list[Item]] = [[] for _ in range(max((item.layer for item in items), default=-1) + 1)]
    for item in items:
        layers[item.layer].append(item)
    for chain in chains:
        full = [chain.items[0]]
        for right in chain.items[1:]:
            for layer in range(full[-1].layer + 1, right.layer):
                bend = Item(0, 1, layer=layer)
                layers[layer].append(bend)
                full.append(bend)
            full.append(right)
        chain.items = full
    return layers


def order(layers: list[list[Item]]) -> None:
    """Sort every layer by the mean place of its neighbours, to and fro; keep the order with the fewest crossings."""
    best = [list(layer) for layer in layers]
    fewest = _crossings(layers)
    for sweep in range(8):
        forward = sweep % 2 == 0
        beside: dict[Item, int] = {}
        for layer in layers if forward else reversed(layers):
            place = {item: float(index) for index, item in enumerate(layer)}
            for item in layer:
                neighbours = item.before if forward else item.after
                if neighbours:
                    place[item] = sum([beside[peer] for peer in neighbours]) / len(neighbours)
            layer.sort(key=place.__getitem__)
            beside = {item: index for index, item in enumerate(layer)}
        crossings = _crossings(layers)
        if crossings < fewest:
            fewest, best = crossings, [list(layer) for layer in layers]
        if fewest == 0:
            break
    for layer, order in zip(layers, best, strict=True):
        layer[:] = order


def _crossings(layers: list[list[Item]]) -> int:
    total = 0
    for left, right in pairwise(layers):
        place = {item: index for index, item in enumerate(right)}
        seen: list[int] = []
        for item in left:
            ends = [place[follower] for follower in item.after]
            total += sum([len(seen) - bisect_right(seen, end) for end in ends])
            for end in ends:
                insort(seen, end)
    return total
