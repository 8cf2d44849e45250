"""The graph as fine lines: round nodes, square topics, curved edges with arrow heads; names stay text."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from itertools import pairwise

from rich.style import Style

from day6_core.ros.programs.rqt_graph.model.drawing import Highlight, is_framed, measure
from day6_core.ros.programs.rqt_graph.model.shapes import Box, LaidOutGraph, Rect, Route
from day6_tui.appearance.colours import background_of, foreground_of
from day6_tui.pixels.bands import Array
from day6_tui.pixels.raster import Surface
from day6_tui.pixels.sheet import Sheet, Text

LINE_WIDTH = 1.4
PULSE_RADIUS = 4.0

Spot = tuple[float, float]


class GraphPicture:
    """`columns` x `rows` cells of `cell` pixels. `style_of` gives the style of a name of `drawing`."""

    def __init__(
        self, columns: int, rows: int, cell: tuple[int, int], blank: Style, style_of: Callable[[str], Style]
    ) -> None:
        self.columns, self.rows, self.cell = columns, rows, cell
        self.sheet = Sheet(columns, rows, blank)
        self._ground = max(0, background_of(blank))
        self._style_of = style_of
        self._offset = (0, 0)

    def pixels(
        self,
        picture: LaidOutGraph,
        offset: tuple[int, int],
        warnings: Iterable[str],
        highlight: Highlight | None,
        pulses: Mapping[Route, float],
    ) -> Array:
        """The graph with its upper left cell at `offset`; `pulses` are how far along their edges they are, 0 to 1."""
        self._offset, marked = offset, set(warnings)
        surface = Surface(self.columns * self.cell[0], self.rows * self.cell[1], self._ground)
        for _, rect in picture.clusters:
            self._box(surface, rect, self._colour("cluster"), rounded=False, inset=0.5)
        styles = {route: highlight.edge(route.edge) if highlight else "edge" for route in picture.routes}
        for route in sorted(picture.routes, key=lambda route: styles[route] != "faded"):
            _, rect = picture.boxes[route.edge.start]
            self._edge(surface, route, rect, self._colour(styles[route]))
        for route, part in pulses.items():
            if route.cells and part <= 1:
                surface.disc(*self._along(route, part), PULSE_RADIUS, self._colour("pulse"))
        for box, rect in picture.boxes.values():
            colour = self._colour(_style_name(box, marked, highlight))
            if rect.height > 1 or is_framed(box, rect):
                self._box(surface, rect, colour, rounded=box.shape == "node")
        return surface.pixels()

    def texts(self, picture: LaidOutGraph, warnings: Iterable[str], highlight: Highlight | None) -> list[Text]:
        """All names, for the sheet, where `drawing` has them."""
        marked, found = set(warnings), []
        for box, rect in picture.boxes.values():
            style = self._style_of(_style_name(box, marked, highlight))
            first = rect.y if rect.height == 1 else rect.y + 1 + (rect.height - 2 - len(box.lines)) // 2
            for number, line in enumerate(box.lines[: max(1, rect.height - 2)]):
                column = rect.x + (rect.width - measure(line)) // 2
                found.append((column, first + number, line, style))
        for route in picture.routes:
            if route.label_at is not None:
                name = highlight.edge(route.edge) if highlight else "warning" if route.edge.key in marked else "label"
                found.append((*route.label_at, route.edge.label, self._style_of(name)))
        found += [(rect.x + 1, rect.y, f" {name} ", self._style_of("cluster")) for name, rect in picture.clusters]
        across, down = self._offset
        return [(column + across, row + down, text, style) for column, row, text, style in found]

    def _colour(self, name: str) -> int:
        style = self._style_of(name)
        # The chosen one is dark on a bright ground: its frame takes the ground's colour.
        back = background_of(style)
        return back if back not in (-1, self._ground) else max(0, foreground_of(style))

    def _middle(self, x: float, y: float) -> Spot:
        return (x + self._offset[0] + 0.5) * self.cell[0], (y + self._offset[1] + 0.5) * self.cell[1]

    def _box(self, surface: Surface, rect: Rect, colour: int, *, rounded: bool, inset: float = 0.3) -> None:
        across, down = self.cell
        inside = inset * down if rect.height > 1 else 1.0
        x, y = rect.x + self._offset[0], rect.y + self._offset[1]
        left, right = x * across + 2.0, (x + rect.width) * across - 2.0
        top, bottom = y * down + inside, (y + rect.height) * down - inside
        radius = min((bottom - top) / 2, (right - left) / 2) if rounded else 3.0
        outline: list[Spot] = []
        for middle_x, middle_y, turn in (
            (right - radius, top + radius, -math.pi / 2),
            (right - radius, bottom - radius, 0.0),
            (left + radius, bottom - radius, math.pi / 2),
            (left + radius, top + radius, math.pi),
        ):
            angles = [turn + math.pi / 2 * step / 8 for step in range(9)]
            outline += [(middle_x + radius * math.cos(angle), middle_y + radius * math.sin(angle)) for angle in angles]
        surface.polygon(outline, self._ground, colour, LINE_WIDTH)

    def _edge(self, surface: Surface, route: Route, box: Rect, colour: int) -> None:
        """A line from its `box`, with an arrow head."""
        spots = [self._middle(*cell) for cell in route.cells]
        if not spots:
            return
        before = spots[-2] if len(spots) > 1 else (spots[-1][0] - 1, spots[-1][1])
        x, y = spots[-1]
        length = math.hypot(x - before[0], y - before[1]) or 1.0
        ux, uy = (x - before[0]) / length, (y - before[1]) / length
        reach = abs(ux) * self.cell[0] / 2 + abs(uy) * self.cell[1] / 2
        tip = x + ux * reach, y + uy * reach
        start = spots[0]
        x0, y0 = route.cells[0]
        inside = box.x <= x0 < box.x + box.width and box.y <= y0 < box.y + box.height
        if len(spots) > 1 and not inside:  # from the box itself
            right, down = (
                (spots[1][0] > start[0]) - (spots[1][0] < start[0]),
                (spots[1][1] > start[1]) - (spots[1][1] < start[1]),
            )
            start = start[0] - right * self.cell[0] * 0.7, start[1] - down * self.cell[1] * 0.7
        surface.line([start, *_curved(spots), (x, y)], colour, LINE_WIDTH)
        size = self.cell[0] * 0.9
        back = tip[0] - ux * size, tip[1] - uy * size
        sides = [(back[0] - uy * size / 2, back[1] + ux * size / 2), (back[0] + uy * size / 2, back[1] - ux * size / 2)]
        surface.polygon([tip, *sides], colour)

    def _along(self, route: Route, part: float) -> Spot:
        """The point of an edge at a part of its way."""
        way = max(0.0, min(1.0, part)) * (len(route.cells) - 1)
        first = min(int(way), len(route.cells) - 1)
        (x0, y0), (x1, y1) = route.cells[first], route.cells[min(first + 1, len(route.cells) - 1)]
        return self._middle(x0 + (x1 - x0) * (way - first), y0 + (y1 - y0) * (way - first))


def _style_name(box: Box, marked: set[str], highlight: Highlight | None) -> str:
    return highlight.box(box.key) if highlight else "warning" if box.key in marked else box.shape


def _curved(spots: list[Spot]) -> list[Spot]:
    """A chain whose corners are cut twice, which leaves straight parts straight."""
    for _ in range(2):
        if len(spots) < 3:
            return spots
        cut = [
            spot
            for (ax, ay), (bx, by) in pairwise(spots)
            for spot in ((ax * 0.75 + bx * 0.25, ay * 0.75 + by * 0.25), (ax * 0.25 + bx * 0.75, ay * 0.25 + by * 0.75))
        ]
        spots = [spots[0], *cut, spots[-1]]
    return spots
