"""A graph as lines that are read like sentences: `/talker ──/chatter──▶ /listener`, where a picture of it has no room.

Each edge has a row. Those of one node leave it together: beside its name, or below it where that is too wide.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import count

from day6_core.ros.programs.rqt_graph.model.drawing import measure
from day6_core.ros.programs.rqt_graph.model.layout import layout
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Cell, Edge, LaidOutGraph, Rect, Route

LEAD = 2
"""Cells of line before a label and after it; then come an arrow and a blank."""


def as_lines(boxes: Sequence[Box], edges: Sequence[Edge], order: Mapping[str, int], *, below: bool) -> LaidOutGraph:
    """Lay out a graph in rows, in an `order` (see `flow`), edges `below` the name of the node that they leave or beside it.

    A node's own place is where edges leave it, else where the first one ends. Where its name stands again it is a box of the
    same key, under another one in `boxes`.
    """
    edges = [edge for edge in edges if edge.start != edge.end]
    by_key = {box.key: box for box in boxes}
    leaving = {key: sorted((e for e in edges if e.start == key), key=lambda e: order[e.end]) for key in order}
    starts = [key for key in order if leaving[key]]
    # Down from here, then to the right.
    trunk = 1 if below else max((measure(by_key[key].lines[0]) for key in starts), default=0) + LEAD
    label_x = trunk + LEAD
    end_x = label_x + max((measure(edge.label) for edge in edges), default=0) + LEAD + 2
    placed: dict[str, tuple[Box, Rect]] = {}
    ends: list[tuple[str, int]] = []
    routes: list[Route] = []
    row = 0
    for key in starts:
        first, name = row, measure(by_key[key].lines[0])
        placed[key] = (by_key[key], Rect(0, first, name, 1))
        before = [(trunk, first)] if below else [(x, first) for x in range(name + 1, trunk + 1)]
        row += below
        for edge in leaving[key]:
            down = [(trunk, y) for y in range(first + 1, row + 1)]
            across = [(x, row) for x in range(trunk + 1, end_x - 1)]
            label_at = (label_x, row) if edge.label else None
            routes.append(Route(edge, tuple[Cell, ...]([*before, *down, *across]), label_at))
            ends.append((edge.end, row))
            row += 1
    again = count()
    for key, y in ends:
        place = (by_key[key], Rect(end_x, y, measure(by_key[key].lines[0]), 1))
        placed[f"{key}\0{next(again)}" if key in placed else key] = place
    for key in order:
        if key not in placed:
            placed[key] = (by_key[key], Rect(0, row, measure(by_key[key].lines[0]), 1))
            row += 1
    width = max((rect.x + rect.width for _, rect in placed.values()), default=0)
    return LaidOutGraph(width, row, placed, tuple(routes))


def flow(boxes: Sequence[Box], edges: Sequence[Edge]) -> dict[str, int]:
    """The boxes in the order in which what they send passes, as in the picture from left to right; each with its place."""
    places = layout(list(boxes), list(edges), measure, roomy=False).boxes
    keys = sorted(places, key=lambda key: (places[key][1].x, places[key][1].y))
    return {key: place for place, key in enumerate(keys)}
