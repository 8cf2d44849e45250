"""Polygon and GridCells (rviz_default_plugins/displays/polygon, grid_cells)."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from day6_core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_core.ros.programs.rviz2.model.properties import COLOUR, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Lines, Points, Scene
from day6_core.ros.programs.rviz2.model.status import ERROR, WARN
from day6_core.ros.programs.rviz2.model.topics import INVALID_FLOATS, FilteredDisplay, all_finite
from day6_urdf.kinematics import Transform
from day6_urdf.model import Vector

MOST_CELLS = 30_000
"""Of these the painter gets so many at most, evenly chosen."""


class _FlatDisplay(FilteredDisplay):
    """Points of a message in one colour."""

    def build(self) -> None:
        super().build()
        self.colour = self.add(Property("Color", COLOUR, (25, 255, 0), on_change=self.changed))
        self.alpha = self.add(floats("Alpha", 1, 0, 1, on_change=self.changed))
        self._points: list[Vector] = []
        self._pose = Transform((0.0, 0.0, 0.0))

    def reset(self) -> None:
        super().reset()
        self._points = []

    def _take(self, header: Any, points: list[Vector], *numbers: float) -> None:
        if not all_finite([*numbers, *(part for point in points for part in point)]):
            self.put_status(ERROR, "Topic", INVALID_FLOATS)
            return
        pose = self.place(header)
        if pose is not None:
            self._points, self._pose = points, pose


class PolygonDisplay(_FlatDisplay):
    """A closed line through the newest points."""

    type = "Polygon"
    message_type = "geometry_msgs/msg/PolygonStamped"

    def show(self, message: Any) -> None:
        self._take(message.header, [(point.x, point.y, point.z) for point in message.polygon.points])

    def draw(self, scene: Scene) -> None:
        if self._points:
            ends = [point for pair in pairwise([*self._points, self._points[0]]) for point in pair]
            scene.lines.append(Lines(ends, [rgba(self.colour, self.alpha.value)], self._pose))


class GridCellsDisplay(_FlatDisplay):
    """Filled cells."""

    type = "GridCells"
    message_type = "nav_msgs/msg/GridCells"

    def build(self) -> None:
        super().build()
        self._size = 0.0

    def show(self, message: Any) -> None:
        self._points = []
        if message.cell_width == 0 or message.cell_height == 0:
            self.put_status(ERROR, "Topic", "One of the Cell's dimension is zero, cells will be invisible.")
        elif not message.cells:
            self.put_status(WARN, "Topic", "Message is empty: there are no cells to be shown.")
        else:
            cells = message.cells[:: max(1, -(-len(message.cells) // MOST_CELLS))]
            self._size = max(message.cell_width, message.cell_height)
            sizes = message.cell_width, message.cell_height
            self._take(message.header, [(cell.x, cell.y, cell.z) for cell in cells], *sizes)

    def draw(self, scene: Scene) -> None:
        if self._points:
            scene.points.append(Points(self._points, [rgba(self.colour, self.alpha.value)], self._size, self._pose))
