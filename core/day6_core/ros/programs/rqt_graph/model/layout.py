"""Layered drawing of a directed graph in terminal cells, left to right.

The method of Sugiyama: break cycles, put boxes into layers, order each layer so that few edges cross, give every item
a row, then route the edges along rows and through vertical tracks between the layers. An edge with a label is split by
its label, which is an item like a box, so labels never lie on anything else. An edge that runs against the direction
keeps its place and carries its arrow at the left end.

Pure: knows nothing of ROS. Coordinates are cells, x to the right, y down.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from day6_core.ros.programs.rqt_graph.model.clusters import Clusters
from day6_core.ros.programs.rqt_graph.model.layers import (
    assign_layers,
    backward_edges,
    fill_layers,
    make_chain,
    order,
)
from day6_core.ros.programs.rqt_graph.model.places import assign_columns, assign_rows, grow_for_ports, route
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Edge, Item, LaidOutGraph, Rect


def layout(
    boxes: list[Box],
    edges: list[Edge],
    measure: Callable[[str], int],
    *,
    roomy: bool = True,
    bundled: bool = False,
) -> LaidOutGraph:
    """Place boxes and edges.

    `measure` gives the width of a text in cells. With `roomy` boxes have a frame above and below (3 rows for one line),
    else each takes a single row. Edges on one side of a box arrive on rows of their own, or `bundled` on one, so that
    those of a tree branch off a common trunk. Edges whose ends are missing are an error (KeyError); self-loops are not drawn.
    """
    items = {box.key: _box_item(box, measure, roomy) for box in boxes}
    edges = [edge for edge in edges if edge.start != edge.end]
    backward = backward_edges([box.key for box in boxes], edges)
    chains = [make_chain(edge, items, edge in backward, measure) for edge in edges]
    everything = [*items.values(), *(chain.label for chain in chains if chain.label is not None)]
    assign_layers(everything, chains)
    layers = fill_layers(everything, chains)
    for chain in chains:
        for left, right in pairwise(chain.items):
            left.after.append(right)
            right.before.append(left)
    order(layers)
    clusters = Clusters(layers)
    clusters.keep_together()
    grow_for_ports(layers, roomy and not bundled)
    assign_rows(layers, gap=1 if roomy else 0)
    clusters.stand_apart()
    width = assign_columns(layers, chains, clusters.margin)
    frames = clusters.frames()
    height = max((item.y + item.height for layer in layers for item in layer), default=0)
    height = max([height, *(rect.y + rect.height for _, rect in frames)])
    placed = {
        item.box.key: (item.box, Rect(item.x, item.y, item.width, item.height)) for item in items.values() if item.box
    }
    return LaidOutGraph(width, height, placed, tuple(route(chain) for chain in chains), frames)


def _box_item(box: Box, measure: Callable[[str], int], roomy: bool) -> Item:
    lines = box.lines if roomy else box.lines[:1]
    if box.shape == "text":
        return Item(max(measure(line) for line in lines) + 2, len(lines), box, box.cluster)
    return Item(max(measure(line) for line in lines) + 4, len(lines) + 2 if roomy else 1, box, box.cluster)
