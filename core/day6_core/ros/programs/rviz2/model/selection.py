"""What was selected in the view, as the panel `Selection` lists it (rviz_common/interaction/selection_manager.cpp)."""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import product
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rviz2.model.properties import GROUP, Property
from day6_core.ros.programs.rviz2.model.scene import Lines, Scene, placed
from day6_urdf.model import Vector

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.manager import RViz

Thing = tuple[Any, Any]
"""A display, and which of its things it is."""

MOST_THINGS = 200
FRAME_COLOUR = (0.6, 0.8, 1.0, 1.0)
_EDGES = [(a, b) for a in range(8) for b in range(8) if a < b and (a ^ b).bit_count() == 1]
"""Of a box whose corners are numbered by the bits x, y, z."""


class Selection:
    """Things by display and key; their lines in the panel follow them as they move."""

    def __init__(self, rviz: RViz) -> None:
        self._rviz = rviz
        self.properties = Property("Selection", GROUP)
        self._lines: dict[Thing, Property] = {}

    @property
    def things(self) -> list[Thing]:
        return list(self._lines)

    def replace(self, things: Iterable[Thing]) -> None:
        """Select these and no others."""
        self._lines.clear()
        self.add_things(things)

    def add_things(self, things: Iterable[Thing]) -> None:
        for thing in things:
            if len(self._lines) < MOST_THINGS:
                self._lines.setdefault(thing, Property("", GROUP)).expanded = True
        self.update()
        self._changed()

    def remove_things(self, things: Iterable[Thing]) -> None:
        for thing in things:
            self._lines.pop(thing, None)
        self._changed()

    def _changed(self) -> None:
        self.properties.children = []
        for line in self._lines.values():
            self.properties.add(line)
        self.properties.expanded = True
        self._rviz.tree_changed()
        self._rviz.touch()

    def update(self) -> None:
        """Take over what the displays say of the things now; what is there no more is selected no more."""
        for (display, key), line in list(self._lines.items()):
            told = display.describe(key) if display in self._rviz.displays and display.enabled else None
            if told is None:
                del self._lines[display, key]
                self._changed()
                continue
            line.name, values = told
            if [child.name for child in line.children] == [value.name for value in values]:
                for child, value in zip(line.children, values, strict=True):
                    child.value = value.value
            else:
                line.children = []
                for value in values:
                    line.add(value)

    @property
    def summary(self) -> str:
        """The first thing in one line, and how many there are; '' if nothing is selected."""
        if not self._lines:
            return ""
        first = next(iter(self._lines.values()))
        text = ", ".join([first.name, *(f"{child.name} {child.text}" for child in first.children)])
        return text if len(self._lines) == 1 else f"{text} … [{len(self._lines)}]"

    def bounds(self, scene: Scene) -> list[tuple[Vector, Vector]]:
        """Least and greatest corner of each selected thing that is in a scene."""
        if not self._lines:
            return []
        return [
            box
            for mark, part in scene.parts()
            if (mark.owner, mark.key) in self._lines and (box := bounding_box(part)) is not None
        ]

    def draw(self, scene: Scene) -> None:
        """A wire box around each thing, as the original's."""
        for low, high in self.bounds(scene):
            corners = [placed_corner(low, high, bits) for bits in range(8)]
            ends = [corners[index] for edge in _EDGES for index in edge]
            scene.lines.append(Lines(ends, [FRAME_COLOUR]))


def placed_corner(low: Vector, high: Vector, bits: int) -> Vector:
    """A corner of a box by the bits of its number."""
    x, y, z = (high[axis] if bits >> axis & 1 else low[axis] for axis in range(3))
    return x, y, z


def corners_of(scene: Scene) -> list[Vector]:
    """Points of the fixed frame that everything solid of a scene lies between."""
    corners: list[Vector] = []
    for shape in scene.shapes:
        half = [size / 2 for size in shape.size]
        corners += [
            placed(shape.pose, (x * half[0], y * half[1], z * half[2])) for x, y, z in product((-1, 1), repeat=3)
        ]
    for mesh in scene.triangles:
        if len(mesh.vertices):
            low, high = mesh.vertices.min(axis=0) * mesh.scale, mesh.vertices.max(axis=0) * mesh.scale
            corners += [placed(mesh.pose, placed_corner(tuple(low), tuple(high), bits)) for bits in range(8)]
    for lines in scene.lines:
        corners += [placed(lines.pose, vertex) for vertex in lines.vertices]
    for points in scene.points:
        if len(points.xyz):
            import numpy as np

            xyz = np.asarray(points.xyz, np.float64)
            corners += [placed(points.pose, tuple(xyz.min(axis=0))), placed(points.pose, tuple(xyz.max(axis=0)))]
    return [corner for corner in corners if all(map(math.isfinite, corner))]


def bounding_box(scene: Scene) -> tuple[Vector, Vector] | None:
    """The box along the axes of the fixed frame that holds everything solid of a scene; None for nothing."""
    corners = corners_of(scene)
    if not corners:
        return None
    low_x, low_y, low_z = (min(corner[axis] for corner in corners) for axis in range(3))
    high_x, high_y, high_z = (max(corner[axis] for corner in corners) for axis in range(3))
    return (low_x, low_y, low_z), (high_x, high_y, high_z)
