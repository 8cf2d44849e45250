"""The forms in which a graph can be drawn, from everything in full to an overview, and the roomiest that fits a window."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from enum import Enum
from functools import cached_property
from itertools import chain, groupby
from typing import NamedTuple

from day6_core.elide import elide
from day6_core.ros.programs.rqt_graph.model.drawing import measure
from day6_core.ros.programs.rqt_graph.model.layout import layout
from day6_core.ros.programs.rqt_graph.model.lines import as_lines, flow
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Cell, Edge, LaidOutGraph, Rect, Route


class Shape(Enum):
    """What a graph is drawn as."""

    ROOMY = "boxes with a frame above and below"
    FLAT = "boxes of one line"
    BESIDE = "lines, the edges beside the node that they leave"
    BELOW = "lines, the edges below it"


class Form(NamedTuple):
    """How a graph is drawn: its shape, the longest topic and node name (0: any), and whether topics are named at all."""

    shape: Shape
    topic: int = 0
    node: int = 0
    labels: bool = True

    @property
    def lines(self) -> bool:
        """Whether each edge has a row of its own."""
        return self.shape in (Shape.BESIDE, Shape.BELOW)


FORMS = (
    Form(Shape.ROOMY),
    Form(Shape.ROOMY, 26),
    Form(Shape.ROOMY, 26, 26),
    Form(Shape.ROOMY, 16, 26),
    Form(Shape.ROOMY, 16, 16),
    Form(Shape.FLAT),
    Form(Shape.FLAT, 26),
    Form(Shape.FLAT, 26, 26),
    Form(Shape.FLAT, 16, 26),
    Form(Shape.BESIDE),
    Form(Shape.BELOW),
    Form(Shape.BESIDE, 26, 26),
    Form(Shape.BELOW, 26, 26),
    Form(Shape.BESIDE, 16, 16),
    Form(Shape.BELOW, 16, 16),
    Form(Shape.BESIDE, 14, 12),
    Form(Shape.BELOW, 11, 14),
    Form(Shape.ROOMY, 11, labels=False),
    Form(Shape.ROOMY, 11, 26, labels=False),
    Form(Shape.ROOMY, 11, 16, labels=False),
    Form(Shape.FLAT, 11, 16, labels=False),
)
"""From the largest picture to the smallest, as a user zooms out. What is named in full comes before what is drawn."""

_LEAST_ROOMY = max(number for number, form in enumerate(FORMS) if form.shape is Shape.ROOMY)

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
            boxes, edges = _shortened(self._boxes, self._edges, FORMS[form], self._ellipsis)
            if FORMS[form].lines:
                below = FORMS[form].shape is Shape.BELOW
                self._pictures[form] = as_lines(boxes, edges, self._flow, below=below)
            else:
                self._pictures[form] = layout(boxes, edges, measure, roomy=FORMS[form].shape is Shape.ROOMY)
        return self._pictures[form]

    def best(self, width: int, height: int) -> int:
        """The first form that fits the window; where none does, lines that are wholly seen across, and go on below."""
        if len(self._boxes) >= _LARGE:
            return OVERVIEW - 1 if self._fits(OVERVIEW - 1, width, height) else OVERVIEW
        forms = [number for number, form in enumerate(FORMS) if not form.lines or self._has_lines]
        fitting = (
            number for number in forms if self._has_room(number, width, height) and self._fits(number, width, height)
        )
        longer = (number for number in forms if FORMS[number].lines and self._size(number, width, height)[0] <= width)
        return next(chain(fitting, longer), OVERVIEW)

    def _has_room(self, number: int, width: int, height: int) -> bool:
        """Whether a form may fit: one that surely doesn't isn't laid out, which takes long where there are many edges."""
        form = FORMS[number]
        if form.lines:
            return len(self._label_sizes) <= height
        if form.shape is Shape.ROOMY and self._most_edges / 2 + 2 > height:
            return False  # one side of a box has a row for each of at least half of its edges
        labels = sum(min(size, form.topic or size) for size in self._label_sizes) if form.labels else 0
        return labels <= width * height

    @cached_property
    def _most_edges(self) -> int:
        ends = Counter(end for edge in self._edges if edge.start != edge.end for end in (edge.start, edge.end))
        return max(ends.values(), default=0)

    @cached_property
    def _label_sizes(self) -> list[int]:
        return [measure(edge.label) for edge in self._edges if edge.start != edge.end]

    @cached_property
    def _flow(self) -> dict[str, int]:
        return flow(self._boxes, self._edges)

    @property
    def _has_lines(self) -> bool:
        """Whether it can be drawn as lines: boxes around namespaces need a picture, and without edges there is no line."""
        return bool(self._edges) and not any(box.cluster for box in self._boxes)

    def next(self, form: int, step: int, width: int, height: int) -> int:
        """The next smaller (step 1) or larger (-1) form that looks different; the same one if there is none."""
        last = OVERVIEW - 1 if self._fits(OVERVIEW - 1, width, height) else OVERVIEW
        now = self._size(form, width, height)
        others = range(form + step, last + 1 if step > 0 else -1, step)
        drawn = (other for other in others if other == OVERVIEW or not FORMS[other].lines or self._has_lines)
        return next((other for other in drawn if self._size(other, width, height) != now), form)

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
    return layout(list(boxes), list(edges), measure)


def _shortened(boxes: Sequence[Box], edges: Sequence[Edge], form: Form, ellipsis: str) -> tuple[list[Box], list[Edge]]:
    """What a form shows of the names; those that are too long for it lack their middle."""
    if form.node:
        boxes = [replace(box, lines=tuple(elide(line, form.node, ellipsis) for line in box.lines)) for box in boxes]
    if form.topic:
        edges = [replace(edge, label=elide(edge.label, form.topic, ellipsis) * form.labels) for edge in edges]
    return list(boxes), list(edges)


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
