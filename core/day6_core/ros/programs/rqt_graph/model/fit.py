"""The forms in which a graph can be drawn, from everything in full to an overview, and the roomiest that fits a window."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby
from typing import NamedTuple

from day6_core.elide import elide
from day6_core.ros.programs.rqt_graph.model.drawing import measure
from day6_core.ros.programs.rqt_graph.model.layout import layout
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Cell, Edge, LaidOutGraph, Rect, Route


class Form(NamedTuple):
    """How a graph is drawn: boxes with a frame above and below or on one line, the longest topic and node name (0: any)."""

    roomy: bool
    topic: int = 0
    node: int = 0
    labels: bool = True
    stacked: bool = False
    """Topics above and below the line instead of in it, where all boxes stand in one row; else as the next form."""


FORMS = (
    Form(True),
    Form(True, 26),
    Form(True, 26, 26),
    Form(True, 16, 26),
    Form(True, 16, 16),
    Form(True, 11, 16),
    Form(False),
    Form(False, 26),
    Form(False, 26, 26),
    Form(False, 16, 26),
    Form(False, 26, 26, stacked=True),
    Form(False, 11, 16),
    Form(True, 11, labels=False),
    Form(True, 11, 26, labels=False),
    Form(True, 11, 16, labels=False),
    Form(False, 11, 16, labels=False),
)
"""From the largest picture to the smallest, as a user zooms out."""

_LEAST_ROOMY = max(form for form, (roomy, *_) in enumerate(FORMS) if roomy)

_LARGE = 60
"""From this many boxes on only the smallest form is tried: no other fits a terminal, and layouts take time."""


OVERVIEW = len(FORMS)
"""The form after the last one: the smallest picture drawn smaller still, as far as the window needs it."""


class Forms:
    """The pictures of one graph, each laid out when it is first wanted. The boxes around namespaces are in all of them."""

    def __init__(self, boxes: Sequence[Box], edges: Sequence[Edge], ellipsis: str = "…") -> None:
        self._boxes, self._edges, self._ellipsis = boxes, edges, ellipsis
        self._pictures: dict[int, LaidOutGraph] = {}

    def picture(self, form: int, width: int, height: int) -> LaidOutGraph:
        """The graph in one of FORMS, or in OVERVIEW for a window of `width` x `height` cells."""
        if form == OVERVIEW:
            # Boxes keep their frames while there are rows enough.
            roomy = len(self._boxes) < _LARGE and self.picture(_LEAST_ROOMY, width, height).height <= height
            base = _LEAST_ROOMY if roomy else OVERVIEW - 1
            return overview(self.picture(base, width, height), width, height, self._ellipsis)
        if form not in self._pictures:
            self._pictures[form] = _formed(self._boxes, self._edges, FORMS[form], self._ellipsis)
        return self._pictures[form]

    def best(self, width: int, height: int) -> int:
        """The first form that fits the window."""
        for form in range(len(FORMS)) if len(self._boxes) < _LARGE else (OVERVIEW - 1,):
            if self._fits(form, width, height):
                return form
        return OVERVIEW

    def next(self, form: int, step: int, width: int, height: int) -> int:
        """The next smaller (step 1) or larger (-1) form that looks different; the same one if there is none."""
        last = OVERVIEW - 1 if self._fits(OVERVIEW - 1, width, height) else OVERVIEW
        now = self._size(form, width, height)
        others = range(form + step, last + 1 if step > 0 else -1, step)
        return next((other for other in others if self._size(other, width, height) != now), form)

    def _fits(self, form: int, width: int, height: int) -> bool:
        across, down = self._size(form, width, height)
        return across <= width and down <= height

    def _size(self, form: int, width: int, height: int) -> tuple[int, int]:
        picture = self.picture(form, width, height)
        return picture.width, picture.height


def fitted(
    boxes: Sequence[Box], edges: Sequence[Edge], width: int, height: int, *, ellipsis: str = "…"
) -> LaidOutGraph:
    """Lay out a graph in the roomiest form that fits `width` x `height` cells, else in the smallest that can be read."""
    forms = Forms(boxes, edges, ellipsis)
    return forms.picture(min(forms.best(width, height), OVERVIEW - 1), width, height)


def unfitted(boxes: Sequence[Box], edges: Sequence[Edge]) -> LaidOutGraph:
    """Lay out a graph with everything in full."""
    return _formed(boxes, edges, FORMS[0], "")


def _formed(boxes: Sequence[Box], edges: Sequence[Edge], form: Form, ellipsis: str) -> LaidOutGraph:
    """Lay out a graph in one form; names that are too long for it are shortened in their middle."""
    if form.stacked:
        smaller = FORMS[FORMS.index(form) + 1]
        return _stacked(boxes, edges, form, ellipsis) or _formed(boxes, edges, smaller, ellipsis)
    if form.node:
        boxes = [replace(box, lines=tuple(elide(line, form.node, ellipsis) for line in box.lines)) for box in boxes]
    if form.topic:
        edges = [replace(edge, label=elide(edge.label, form.topic, ellipsis) * form.labels) for edge in edges]
    return layout(list(boxes), list(edges), measure, roomy=form.roomy)


def _stacked(boxes: Sequence[Box], edges: Sequence[Edge], form: Form, ellipsis: str) -> LaidOutGraph | None:
    """Boxes in one row with short lines between neighbours; what flows to the right stands above the line, the rest below.

    None where the boxes do not stand so.
    """
    picture = _formed(boxes, edges, form._replace(stacked=False, labels=False), ellipsis)
    rects = sorted((rect for _, rect in picture.boxes.values()), key=lambda rect: rect.x)
    if picture.height != 1 or not picture.routes or picture.clusters:
        return None
    before = {key: rects.index(rect) for key, (_, rect) in picture.boxes.items()}
    names = {(edge.start, edge.end, edge.key): edge.label for edge in edges}
    taken: dict[int, int] = {}  # row -> the first column that is free
    placed: list[tuple[Route, int, int]] = []
    for route in sorted(picture.routes, key=lambda route: min(before[route.edge.start], before[route.edge.end])):
        edge = route.edge
        left, right = sorted((before[edge.start], before[edge.end]))
        if right != left + 1:
            return None
        label = elide(names[edge.start, edge.end, edge.key], form.topic, ellipsis)
        gap = (rects[left].x + rects[left].width + rects[right].x) // 2
        x, step = max(0, gap - measure(label) // 2), -1 if before[edge.start] == left else 1
        row = step
        while taken.get(row, 0) > x:
            row += step
        taken[row] = x + measure(label) + 1
        placed.append((replace(route, edge=replace(edge, label=label)), x, row))
    down = -min(0, *taken)
    routes = tuple(
        replace(route, cells=tuple((x, y + down) for x, y in route.cells), label_at=(label_x, row + down))
        for route, label_x, row in placed
    )
    return LaidOutGraph(
        max(picture.width, *(end - 1 for end in taken.values())),
        down + 1 + max(0, *taken),
        {key: (box, replace(rect, y=rect.y + down)) for key, (box, rect) in picture.boxes.items()},
        routes,
    )


def overview(picture: LaidOutGraph, width: int, height: int, ellipsis: str = "…") -> LaidOutGraph:
    """The whole picture drawn smaller, into `width` x `height` cells: of the names stays what has room, else a mark.

    Where rows must go, boxes are expected to have a single one.
    """
    frames, rects = [rect for _, rect in picture.clusters], [rect for _, rect in picture.boxes.values()]
    # What is dropped first is what only edges run through.
    sides = {rect.x for rect in frames} | {rect.x + rect.width - 1 for rect in frames}
    # Where edges begin and end, arrows included.
    sides |= {column for route in picture.routes for column, _ in (*route.cells[:2], *route.cells[-2:])}
    names = {column for rect in rects for column in range(rect.x, rect.x + rect.width)}
    tops, bottoms = {rect.y for rect in (*frames, *rects)}, {rect.y + rect.height - 1 for rect in (*frames, *rects)}
    columns = _shrunk(picture.width, width, sides, names)
    rows = _shrunk(picture.height, height, tops, bottoms)

    def place(x: int, y: int) -> Cell:
        return columns[x], rows[y]

    def shrunk(rect: Rect) -> Rect:
        left, top = place(rect.x, rect.y)
        right, bottom = place(rect.x + rect.width - 1, rect.y + rect.height - 1)
        return Rect(left, top, right - left + 1, bottom - top + 1)

    boxes = {}
    for key, (box, rect) in picture.boxes.items():
        small = shrunk(rect)
        if 1 < rect.height == small.height and small.width > 6:
            lines = tuple(elide(line, small.width - 4, ellipsis) for line in box.lines)
        else:
            small, lines = replace(small, height=1), (_short_name(box, small.width, ellipsis),)
        boxes[key] = (replace(box, lines=lines), small)
    routes = tuple(
        Route(route.edge, tuple(cell for cell, _ in groupby(place(*cell) for cell in route.cells)), None)
        for route in picture.routes
    )
    clusters = tuple((name, shrunk(rect)) for name, rect in picture.clusters)
    return LaidOutGraph(min(width, picture.width), min(height, picture.height), boxes, routes, clusters)


def _shrunk(size: int, room: int, *kept: set[int]) -> list[int]:
    """Where each of `size` lines comes to lie in `room`: those kept first have one of their own as long as there is room."""
    share = dict.fromkeys(range(size), 0.0)
    left = min(size, room)
    told: set[int] = set()
    for lines in (*kept, set(share)):
        lines = lines - told
        told |= lines
        share.update(dict.fromkeys(lines, min(1.0, left / max(1, len(lines)))))
        left = max(0, left - len(lines))
    places, before = [], 1e-9
    for line in range(size):
        places.append(min(int(before), max(0, room - 1)))
        before += share[line]
    return places


def _short_name(box: Box, width: int, ellipsis: str) -> str:
    """The name of a box in `width` cells: with its frame, without, or a mark where there is no room for any of it."""
    if measure(box.lines[0]) <= width:
        return box.lines[0]
    if width < 4:
        return ("o" if box.shape == "node" else "#") * min(width, 1)
    return elide(box.lines[0].rpartition("/")[2], width, ellipsis)
