"""A laid-out graph as rows of text: ellipses for nodes, boxes for topics, lines with arrows."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import pairwise

from wcwidth import wcwidth

from day6_tui.core.ros.programs.rqt_graph._layout import Box, Cell, Picture, Rect, Route

Run = tuple[str, str]
"""A piece of text and the name of its style: node, topic, group, warning, edge, label, pulse or ''."""

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
    sides: str
    right: str
    left: str
    up: str
    down: str
    pulse: str

    @property
    def across(self) -> str:
        """A horizontal line."""
        return self.lines[_EAST | _WEST]

    @property
    def upright(self) -> str:
        """A vertical line."""
        return self.lines[_NORTH | _SOUTH]


UNICODE = Glyphs(_BOX_LINES, "╭╮╰╯", "┌┐└┘", "()", "▶", "◀", "▲", "▼", "●")
CONSOLE = Glyphs(_BOX_LINES, "┌┐└┘", "┌┐└┘", "()", ">", "<", "^", "v", "*")
"""The plain Linux console: its fonts lack round corners and triangles."""
ASCII = Glyphs(" |-+|||+-+-+++++", "/\\\\/", "++++", "()", ">", "<", "^", "v", "*")


@dataclass
class Canvas:
    """A grid of cells, each one character and a style; a wide character is followed by an empty cell."""

    width: int
    height: int
    text: list[list[str]] = field(init=False)
    style: list[list[str]] = field(init=False)

    def __post_init__(self) -> None:
        self.text = [[" "] * self.width for _ in range(self.height)]
        self.style = [[""] * self.width for _ in range(self.height)]

    def put(self, x: int, y: int, text: str, style: str) -> None:
        """Write text from a cell to the right; what does not fit is cut."""
        if not 0 <= y < self.height:
            return
        for character in text:
            cells = max(1, wcwidth(character))
            if x >= 0 and x + cells <= self.width:
                self.text[y][x] = character
                self.style[y][x] = style
                if cells == 2:
                    self.text[y][x + 1] = ""
                    self.style[y][x + 1] = style
            x += cells

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
    return sum(max(0, wcwidth(character)) for character in text)


def draw(picture: Picture, glyphs: Glyphs, warnings: Iterable[str] = ()) -> Canvas:
    """Draw boxes and edges; boxes whose key is in `warnings` are drawn in the warning style."""
    canvas = Canvas(picture.width, picture.height)
    _draw_lines(canvas, picture.routes, glyphs)
    for route in picture.routes:
        if route.label_at is not None:
            canvas.put(*route.label_at, route.edge.label, "label")
        if route.cells:
            canvas.put(*route.cells[-1], _arrow(route, glyphs), "edge")
    marked = set(warnings)
    for box, rect in picture.boxes.values():
        _draw_box(canvas, box, rect, glyphs, "warning" if box.key in marked else box.shape)
    return canvas


def draw_pulse(canvas: Canvas, route: Route, progress: float, glyphs: Glyphs) -> None:
    """Put a pulse on an edge; `progress` runs from 0 (start) to 1 (end)."""
    if route.cells:
        x, y = route.cells[min(int(progress * len(route.cells)), len(route.cells) - 1)]
        if canvas.text[y][x]:
            canvas.put(x, y, glyphs.pulse, "pulse")


def _draw_lines(canvas: Canvas, routes: Iterable[Route], glyphs: Glyphs) -> None:
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
        canvas.put(x, y, glyphs.lines[mask], "edge")


def _arrow(route: Route, glyphs: Glyphs) -> str:
    if len(route.cells) == 1:
        return glyphs.right
    (x0, y0), (x1, y1) = route.cells[-2:]
    if x0 == x1:
        return glyphs.down if y1 > y0 else glyphs.up
    return glyphs.right if x1 > x0 else glyphs.left


def _draw_box(canvas: Canvas, box: Box, rect: Rect, glyphs: Glyphs, style: str) -> None:
    round_shape = box.shape == "node"
    x, y, width, height = rect.x, rect.y, rect.width, rect.height
    if height == 1:
        left, right = tuple(glyphs.sides if round_shape else "[]")
        canvas.put(x, y, f"{left} {box.lines[0]} {right}", style)
        return
    corners = glyphs.round_corners if round_shape else glyphs.square_corners
    inset = 1 if round_shape else 0
    bar = glyphs.across * (width - 2 - 2 * inset)
    canvas.put(x + inset, y, corners[0] + bar + corners[1], style)
    canvas.put(x + inset, y + height - 1, corners[2] + bar + corners[3], style)
    sides = glyphs.sides if round_shape else glyphs.upright * 2
    for row in range(y + 1, y + height - 1):
        canvas.put(x, row, sides[0] + " " * (width - 2) + sides[1], style)
    first = y + 1 + (height - 2 - len(box.lines)) // 2
    for index, line in enumerate(box.lines):
        canvas.put(x + (width - measure(line)) // 2, first + index, line, style)
