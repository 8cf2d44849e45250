"""What a layout is made of: boxes and edges given, rectangles and routes found, and the items in between."""

from __future__ import annotations

from dataclasses import dataclass, field

Cell = tuple[int, int]


@dataclass(frozen=True)
class Box:
    """Something to draw: `lines` of text in a frame of some `shape`; `cluster` names the namespace box it lies in.

    The shape "text" has no frame, and arrows go on through it: what stands on an edge.
    A cluster lies in those whose names are a beginning of its own: /a/b in /a.
    """

    key: str
    lines: tuple[str, ...]
    shape: str
    cluster: str = ""


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
class LaidOutGraph:
    """A finished layout."""

    width: int
    height: int
    boxes: dict[str, tuple[Box, Rect]]
    routes: tuple[Route, ...]
    clusters: tuple[tuple[str, Rect], ...] = ()
    """Frames around the members of a namespace, outer ones first."""


@dataclass(eq=False)
class Item:
    """A box, a label or a bend of a long edge."""

    width: int
    height: int
    box: Box | None = None
    cluster: str = ""
    layer: int = 0
    x: int = 0
    y: int = 0
    before: list[Item] = field(default_factory=list)
    after: list[Item] = field(default_factory=list)

    @property
    def middle(self) -> float:
        return self.y + (self.height - 1) / 2


@dataclass(eq=False)
class Segment:
    """One piece of an edge between two neighbouring layers."""

    left: Item
    right: Item
    row: int = 0
    end_row: int = 0
    track: int = 0


@dataclass(eq=False)
class Chain:
    """An edge as a path of items; `reversed` when it was turned round to break a cycle."""

    edge: Edge
    items: list[Item]
    reversed: bool
    label: Item | None
    segments: list[Segment] = field(default_factory=list)


def common(one: str, other: str) -> str:
    """Return the innermost cluster that holds both, '' if none does."""
    while one and not within(other, one):
        one = one.rpartition("/")[0]
    return one


def within(cluster: str, outer: str) -> bool:
    """Whether a cluster equals another or lies in it."""
    return cluster == outer or cluster.startswith(outer + "/")
