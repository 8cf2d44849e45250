"""A laid-out graph as rows of text: ellipses for nodes, boxes for topics, lines with arrows."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import pairwise

from day6_core.ros.programs.rqt_graph.model.shapes import Box, Cell, Edge, LaidOutGraph, Rect, Route
from day6_core.width import char_width

Run = tuple[str, str]
"""A piece of text and the name of its style: node, topic, group, cluster, warning, edge, label, pulse or ''.

With a highlight on, what does not belong to it is "faded", and the rest "chosen", "incoming" or "outgoing".
"""

_NORTH, _EAST, _SOUTH, _WEST = 1, 2, 4, 8
_DIRECTION = {(0, -1): _NORTH, (1, 0): _EAST, (0, 1): _SOUTH, (-1, 0): _WEST}
_BOX_LINES = " ╵╶└╷│┌├╴┘─┴┐┤┬┼"
_ASCII_LINES = " |-+||++-+-++++ +"


@dataclass(frozen=True)
class Glyphs:
    """The characters a terminal can show. `corners`: top left, top right, bottom left, bottom right."""

    lines: str
    round_corners: str
    square_corners: str
    slanted: bool
    """Whether the round corners are slashes: they join the sides one column further out."""
    right: str
    left: str
    up: str
    down: str
    pulse: str

    @property
    def drawn(self) -> str:
        """All of them that edges are drawn with."""
        return self.lines[1:] + self.right + self.left + self.up + self.down

    @property
    def across(self) -> str:
        """A horizontal line."""
        return self.lines[_EAST | _WEST]

    @property
    def upright(self) -> str:
        """A vertical line."""
        return self.lines[_NORTH | _SOUTH]


UNICODE = Glyphs(_BOX_LINES, "╭╮╰╯", "┌┐└┘", False, "▶", "◀", "▲", "▼", "●")
CONSOLE = Glyphs(_BOX_LINES, "/\\\\/", "┌┐└┘", True, ">", "<", "^", "v", "*")
"""The plain Linux console: its fonts lack round corners and triangles."""
ASCII = Glyphs(" |-+|||+-+-+++++", "/\\\\/", "++++", True, ">", "<", "^", "v", "*")


@dataclass
class CellCanvas:
    """A grid of cells, each one character and a style; a wide character is followed by an empty cell.

    Its first cell is the cell (`left`, `top`) of what is drawn on it.
    """

    width: int
    height: int
    left: int = 0
    top: int = 0
    text: list[list[str]] = field(init=False)
    style: list[list[str]] = field(init=False)

    def __post_init__(self) -> None:
        self.text = [[" "] * self.width for _ in range(self.height)]
        self.style = [[""] * self.width for _ in range(self.height)]

    def put(self, x: int, y: int, text: str, style: str) -> None:
        """Write text from a cell to the right; what does not fit is cut."""
        x, y = x - self.left, y - self.top
        if not 0 <= y < self.height:
            return
        for character in text:
            cells = max(1, char_width(character))
            if x >= 0 and x + cells <= self.width:
                self.text[y][x] = character
                self.style[y][x] = style
                if cells == 2:
                    self.text[y][x + 1] = ""
                    self.style[y][x + 1] = style
            x += cells

    def copy(self) -> CellCanvas:
        """Return a canvas with the same cells."""
        copy = CellCanvas(0, 0, self.left, self.top)
        copy.width, copy.height = self.width, self.height
        copy.text, copy.style = [row[:] for row in self.text], [row[:] for row in self.style]
        return copy

    def shows(self, x: int, y: int) -> bool:
        """Whether a cell of what is drawn lies on the canvas."""
        return 0 <= x - self.left < self.width and 0 <= y - self.top < self.height

    def rows(self) -> list[list[Run]]:
        """Return the rows as runs of one style each."""
        found = []
        for characters, styles in zip(self.text, self.style, strict=True):
            row: list[Run] = []
            start = 0
            for index in range(1, self.width + 1):
                if index == self.width or styles[index] != styles[start]:
                    row.append(("".join(characters[start:index]), styles[start]))
                    start = index
            found.append(row)
        return found


def measure(text: str) -> int:
    """Return the width of a text in terminal cells."""
    return sum(map(char_width, text))


def draw(
    picture: LaidOutGraph,
    glyphs: Glyphs,
    warnings: Iterable[str] = (),
    highlight: Highlight | None = None,
    part: Rect | None = None,
) -> CellCanvas:
    """Draw frames, boxes and edges; of a picture larger than the window only the `part` that is seen.

    What has its key in `warnings` is drawn in the warning style; with a `highlight` the rest of the picture is faded.
    """
    canvas = CellCanvas(part.width, part.height, part.x, part.y) if part else CellCanvas(picture.width, picture.height)
    marked = set(warnings)
    for name, rect in picture.clusters:
        _draw_frame(canvas, name, rect, glyphs)
    styles = {route: highlight.edge(route.edge) if highlight else "edge" for route in picture.routes}
    routes = sorted(picture.routes, key=lambda route: styles[route] != "faded")
    for style in dict.fromkeys(styles[route] for route in routes):
        _draw_lines(canvas, [route for route in routes if styles[route] == style], glyphs, style)
    for route in routes:
        style = styles[route]
        if route.label_at is not None:
            label = style if highlight else "warning" if route.edge.key in marked else "label"
            canvas.put(*route.label_at, route.edge.label, label)
        if route.cells:
            canvas.put(*route.cells[-1], _arrow(route, glyphs), style)
    # The highlighted one last: in an overview boxes can lie on each other.
    for box, rect in sorted(
        picture.boxes.values(), key=lambda each: highlight is not None and each[0].key == highlight.key
    ):
        style = highlight.box(box.key) if highlight else "warning" if box.key in marked else box.shape
        _draw_box(canvas, box, rect, glyphs, style)
    return canvas


class Highlight:
    """What belongs to one box: the edges that arrive and leave, and the boxes at their other ends."""

    def __init__(self, key: str, edges: Iterable[Edge]) -> None:
        self.key = key
        edges = list(edges)
        self._before = {edge.start for edge in edges if edge.end == key}
        self._after = {edge.end for edge in edges if edge.start == key}

    def edge(self, edge: Edge) -> str:
        """Return the style of an edge."""
        return "outgoing" if edge.start == self.key else "incoming" if edge.end == self.key else "faded"

    def box(self, key: str) -> str:
        """Return the style of a box."""
        if key == self.key:
            return "chosen"
        return "outgoing" if key in self._after else "incoming" if key in self._before else "faded"


def draw_pulse(canvas: CellCanvas, route: Route, progress: float, glyphs: Glyphs) -> None:
    """Put a pulse on an edge; `progress` runs from 0 (start) to 1 (end). It goes on behind what is written."""
    cells = [cell for cell in route.cells if not _is_written(route, cell)]
    if cells:
        cells = cells[:-1] or cells  # the arrow stays
        x, y = cells[min(int(progress * len(cells)), len(cells) - 1)]
        if canvas.shows(x, y) and canvas.text[y - canvas.top][x - canvas.left] in glyphs.drawn:
            canvas.put(x, y, glyphs.pulse, "pulse")


def _is_written(route: Route, cell: Cell) -> bool:
    """Whether a cell of an edge is one of its label's."""
    if route.label_at is None:
        return False
    x, y = route.label_at
    return cell[1] == y and x <= cell[0] < x + measure(route.edge.label)


def is_framed(box: Box, rect: Rect) -> bool:
    """Whether a box of one row has something around its name."""
    return measure(box.lines[0]) + 4 <= rect.width


def _draw_frame(canvas: CellCanvas, name: str, rect: Rect, glyphs: Glyphs) -> None:
    """Draw a namespace's frame with its name in the upper edge."""
    right, bottom = rect.x + rect.width - 1, rect.y + rect.height - 1
    corners = glyphs.square_corners
    canvas.put(rect.x, rect.y, corners[0] + glyphs.across * (rect.width - 2) + corners[1], "cluster")
    canvas.put(rect.x, bottom, corners[2] + glyphs.across * (rect.width - 2) + corners[3], "cluster")
    for row in range(rect.y + 1, bottom):
        canvas.put(rect.x, row, glyphs.upright, "cluster")
        canvas.put(right, row, glyphs.upright, "cluster")
    canvas.put(rect.x + 1, rect.y, f" {name} ", "cluster")


def _draw_lines(canvas: CellCanvas, routes: Iterable[Route], glyphs: Glyphs, style: str) -> None:
    masks: dict[Cell, int] = {}
    for route in routes:
        for first, second in pairwise(route.cells):
            step = (second[0] - first[0], second[1] - first[1])
            if step in _DIRECTION:
                masks[first] = masks.get(first, 0) | _DIRECTION[step]
                masks[second] = masks.get(second, 0) | _DIRECTION[(-step[0], -step[1])]
        for end, beside in ((0, 1), (-1, -2)):
            if len(route.cells) > 1 and route.cells[end][1] == route.cells[beside][1]:
                masks[route.cells[end]] = masks.get(route.cells[end], 0) | _EAST | _WEST
    for (x, y), mask in masks.items():
        if canvas.shows(x, y):
            canvas.put(x, y, glyphs.lines[mask], style)


def _arrow(route: Route, glyphs: Glyphs) -> str:
    if len(route.cells) == 1:
        return glyphs.right
    (x0, y0), (x1, y1) = route.cells[-2:]
    if x0 == x1:
        return glyphs.down if y1 > y0 else glyphs.up
    return glyphs.right if x1 > x0 else glyphs.left


def _draw_box(canvas: CellCanvas, box: Box, rect: Rect, glyphs: Glyphs, style: str) -> None:
    round_shape = box.shape == "node"
    x, y, width, height = rect.x, rect.y, rect.width, rect.height
    if height == 1:
        left, right = ("( ", " )") if round_shape else ("[ ", " ]")
        canvas.put(x, y, f"{left}{box.lines[0]}{right}" if is_framed(box, rect) else box.lines[0], style)
        return
    corners = glyphs.round_corners if round_shape else glyphs.square_corners
    slanted = round_shape and glyphs.slanted
    inset = 1 if slanted else 0
    bar = glyphs.across * (width - 2 - 2 * inset)
    canvas.put(x + inset, y, corners[0] + bar + corners[1], style)
    canvas.put(x + inset, y + height - 1, corners[2] + bar + corners[3], style)
    for row in range(1, height - 1):
        left, right = _slanted_sides(row, height) if slanted else (glyphs.upright, glyphs.upright)
        canvas.put(x, y + row, left + " " * (width - 2) + right, style)
    first = y + 1 + (height - 2 - len(box.lines)) // 2
    for index, line in enumerate(box.lines):
        canvas.put(x + (width - measure(line)) // 2, first + index, line, style)


def _slanted_sides(row: int, height: int) -> tuple[str, str]:
    """The sides of an ellipse made of ASCII characters: they continue the slashes of its corners."""
    if height == 3:
        return "(", ")"
    return ("/", "\\") if row == 1 else ("\\", "/") if row == height - 2 else ("|", "|")
