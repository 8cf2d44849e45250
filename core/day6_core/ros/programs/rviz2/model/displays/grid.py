"""Grid (rviz_default_plugins/displays/grid)."""

from __future__ import annotations

from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.properties import (
    COLOUR,
    ENUM,
    FIXED_FRAME,
    FRAME,
    INT,
    VECTOR,
    Property,
    floats,
)
from day6_core.ros.programs.rviz2.model.scene import Lines, Scene
from day6_urdf.kinematics import Transform, compose
from day6_urdf.model import Vector

MOST_LINES = 4000
"""More cells than make this many lines are not drawn: nobody could tell them apart."""


class GridDisplay(Display):
    """Lines in a plane of a frame."""

    type = "Grid"

    def build(self) -> None:
        changed = self.changed
        self.frame = Property("Reference Frame", FRAME, FIXED_FRAME, options=self.rviz.frame_choices, on_change=changed)
        self.cells = Property("Plane Cell Count", INT, 10, low=1, on_change=changed)
        self.levels = Property("Normal Cell Count", INT, 0, low=0, on_change=changed)
        self.size = floats("Cell Size", 1, 0.0001, on_change=changed)
        self.style = Property("Line Style", ENUM, "Lines", options=("Lines", "Billboards"), on_change=self._style)
        self.width = floats("Line Width", 0.03, 0.001, hidden=True, on_change=changed)
        self.colour = Property("Color", COLOUR, (160, 160, 164), on_change=changed)
        self.alpha = floats("Alpha", 0.5, 0, 1, on_change=changed)
        self.plane = Property("Plane", ENUM, "XY", options=("XY", "XZ", "YZ"), on_change=changed)
        self.offset = Property("Offset", VECTOR, (0.0, 0.0, 0.0), on_change=changed)
        self.style.add(self.width)
        for each in (self.frame, self.cells, self.levels, self.size, self.style, self.colour, self.alpha, self.plane):
            self.add(each)
        self.add(self.offset)
        self._made: tuple[object, ...] = ()
        self._lines: Lines | None = None

    def _style(self) -> None:
        self.width.hidden = self.style.value == "Lines"
        self.changed()

    def refresh(self) -> None:
        if self.rviz.frames.pose(self.frame.value) is None:
            self.transform_missing(self.frame.value)
        else:
            self.transform_ok()

    def draw(self, scene: Scene) -> None:
        pose = self.rviz.frames.pose(self.frame.value)
        if pose is None:
            return
        wanted = (pose, *(each.value for each in (*self.children, self.width) if each is not self.statuses))
        if wanted != self._made:
            self._made = wanted
            self._lines = self._make(compose(pose, Transform(self.offset.value)))
        if self._lines is not None:
            scene.lines.append(self._lines)

    def _make(self, pose: Transform) -> Lines:
        cells, levels, size = int(self.cells.value), int(self.levels.value), float(self.size.value)
        if (cells + 1) * 2 * (levels + 1) > MOST_LINES:
            cells, size = MOST_LINES // (2 * (levels + 1)), size * cells / max(1, MOST_LINES // (2 * (levels + 1)))
        half = cells * size / 2
        vertices: list[Vector] = []
        for level in range(levels + 1):
            # A flat grid lies in the plane; a high one stands around it.
            height = (level - levels / 2) * size
            for index in range(cells + 1):
                at = index * size - half
                for a, b in (((-half, at), (half, at)), ((at, -half), (at, half))):
                    vertices += [self._in_plane(*a, height), self._in_plane(*b, height)]
        if levels:
            low, high = -levels / 2 * size, levels / 2 * size
            for x in range(cells + 1):
                for y in range(cells + 1):
                    u, v = x * size - half, y * size - half
                    vertices += [self._in_plane(u, v, low), self._in_plane(u, v, high)]
        red, green, blue = self.colour.value
        width = self.width.value if self.style.value == "Billboards" else 0.0
        return Lines(
            vertices, [(red / 255, green / 255, blue / 255, self.alpha.value)], pose, width, lattice=levels == 0
        )

    def _in_plane(self, u: float, v: float, normal: float) -> Vector:
        plane = self.plane.value
        return (u, v, normal) if plane == "XY" else (u, normal, v) if plane == "XZ" else (normal, u, v)
