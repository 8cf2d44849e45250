"""Choosing the roomiest picture that fits a window."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from day6_tui.core.ros.programs.rqt_graph.model.drawing import measure
from day6_tui.core.ros.programs.rqt_graph.model.layout import layout
from day6_tui.core.ros.programs.rqt_graph.model.shapes import Box, Edge, Picture

_ATTEMPTS = ((True, 0), (True, 26), (True, 16), (False, 0), (False, 26), (False, 16), (False, 11))
"""What is tried in turn: frames around boxes or not, and the longest label (0: any)."""

_LARGE = 60
"""From this many boxes on only the smallest form is tried: none fits a terminal, and layouts take time."""


def fitted(boxes: Sequence[Box], edges: Sequence[Edge], width: int, height: int, *, ellipsis: str = "…") -> Picture:
    """Lay out a graph for a window of `width` x `height` cells.

    Long labels are shortened in their middle, then frames go, then the boxes around namespaces. When nothing fits, the
    smallest attempt is returned and the window scrolls.
    """
    smallest: Picture | None = None
    for roomy, longest in _ATTEMPTS if len(boxes) < _LARGE else _ATTEMPTS[-1:]:
        shortened = [replace(edge, label=elide(edge.label, longest, ellipsis)) for edge in edges] if longest else edges
        picture = layout(list(boxes), list(shortened), measure, roomy=roomy)
        if picture.width <= width and picture.height <= height:
            return picture
        if smallest is None or picture.width * picture.height < smallest.width * smallest.height:
            smallest = picture
    assert smallest is not None
    if any(box.cluster for box in boxes):
        bare = fitted([replace(box, cluster="") for box in boxes], edges, width, height, ellipsis=ellipsis)
        if bare.width <= width and bare.height <= height:
            return bare
    return smallest


def unfitted(boxes: Sequence[Box], edges: Sequence[Edge]) -> Picture:
    """Lay out a graph with everything in full; the window scrolls."""
    return layout(list(boxes), list(edges), measure)


def elide(name: str, longest: int, ellipsis: str) -> str:
    """Shorten a topic name to `longest` cells: its first and last parts stay, the middle becomes an ellipsis."""
    if measure(name) <= longest:
        return name
    parts = name.split("/")
    for kept in range(len(parts) - 2, 0, -1):
        short = "/".join([*parts[:2], ellipsis, *parts[-kept:]])
        if kept < len(parts) - 2 and measure(short) <= longest:
            return short
    for kept in range(len(parts) - 1, 0, -1):
        short = "/".join([ellipsis, *parts[-kept:]])
        if measure(short) <= longest:
            return short
    return ellipsis + name[len(name) - longest + len(ellipsis) :]
