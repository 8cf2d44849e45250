"""What lies under a place of the picture: its ray, and the nearest thing that can be picked.

The things are painted once more, only where the mouse is, into a picture of a few pixels.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from day6_core.ros.programs.rviz2.model.scene import Mark, Scene
from day6_core.ros.programs.rviz2.model.tools.tool import Hit, Pointer
from day6_core.ros.programs.rviz2.model.views import NOMINAL_HEIGHT, Camera
from day6_tui.render.lines import Segments, paint_points
from day6_tui.render.picture import FAR, Array, RenderedPicture
from day6_tui.render.solids import paint_solids
from day6_tui.render.triangles import paint_triangles

ACROSS, DOWN = 4, 8
"""Pixels of a cell while looking for what is in it; they are square."""

AROUND = 1
"""Cells around the one pointed to that are searched if nothing is in it: lines are thin, and cells coarse."""


class Screen(NamedTuple):
    """The view: its camera, and its size in cells."""

    camera: Camera
    columns: int
    rows: int

    def part(self, left: int, top: int, columns: int, rows: int) -> RenderedPicture:
        """An empty picture of some of the cells, as they are seen in the whole one."""
        picture = RenderedPicture(columns * ACROSS, rows * DOWN, 1.0, self.camera, (0, 0, 0))
        scale = self.rows / rows
        picture.across, picture.down = picture.across * scale, picture.down * scale
        picture.offset = (
            (self.columns / 2 - left - columns / 2) * ACROSS,
            (self.rows / 2 - top - rows / 2) * DOWN,
        )
        return picture

    def ray(self, x: float, y: float) -> tuple[Array, Array]:
        """Start and direction of the ray through a place, in cells from the upper left corner."""
        picture = self.part(int(x), int(y), 1, 1)
        picture.offset = (
            picture.offset[0] + (int(x) + 0.5 - x) * ACROSS,
            picture.offset[1] + (int(y) + 0.5 - y) * DOWN,
        )
        # Between the middle pixels.
        starts, along = picture.rays(0, 0, ACROSS, DOWN)
        start: Array = starts.mean(axis=(0, 1))
        direction: Array = along.mean(axis=(0, 1))
        return start, direction


def point_at(scene: Scene, screen: Screen, x: float, y: float, *, search: bool) -> Pointer:
    """What a place in the view points to; `search` also for things, which takes longer."""
    start, along = screen.ray(x, y)
    hit = _nearest(scene, screen, int(x), int(y)) if search else None
    height = NOMINAL_HEIGHT / max(1, screen.rows)
    return Pointer(_vector(start), _vector(along), hit, (x * height / 2, y * height))


def _nearest(scene: Scene, screen: Screen, column: int, row: int) -> Hit | None:
    """The thing in the middle of a cell, else the one nearest to it around."""
    left, top, size = column - AROUND, row - AROUND, 2 * AROUND + 1
    picture = screen.part(left, top, size, size)
    owners: Array = np.full(picture.depth.shape, -1)
    marks: list[Mark] = []
    for mark, painted in _painted(picture, scene):
        owners[painted] = len(marks)
        marks.append(mark)
    y, x = np.nonzero(owners >= 0)
    if not len(x):
        return None
    away = (x - (picture.width - 1) / 2) ** 2 + (y - (picture.height - 1) / 2) ** 2
    best = int(away.argmin())
    at_x, at_y = int(x[best]), int(y[best])
    starts, along = picture.rays(at_x, at_y, at_x + 1, at_y + 1)
    point = starts[0, 0] + along[0, 0] * float(picture.depth[at_y, at_x])
    mark = marks[int(owners[at_y, at_x])]
    return Hit(_vector(point), mark.owner, mark.key)


def things_in(
    scene: Scene, screen: Screen, left: int, top: int, right: int, bottom: int
) -> tuple[tuple[object, object], ...]:
    """Owners and keys of the things seen in a rectangle of cells, the largest first."""
    picture = screen.part(left, top, max(1, right - left), max(1, bottom - top))
    owners: Array = np.full(picture.depth.shape, -1)
    marks: list[Mark] = []
    for mark, painted in _painted(picture, scene):
        owners[painted] = len(marks)
        marks.append(mark)
    numbers, counts = np.unique(owners[owners >= 0], return_counts=True)
    order = np.argsort(-counts, kind="stable")
    return tuple(dict.fromkeys((marks[number].owner, marks[number].key) for number in numbers[order].tolist()))


def _painted(picture: RenderedPicture, scene: Scene) -> Iterator[tuple[Mark, Array]]:
    """Each thing, and in which pixels it is nearer than those before it."""
    for mark, part in scene.parts():
        before = picture.depth.copy()
        thin = Segments()
        paint_solids(picture, part.shapes, 1, thin)
        paint_triangles(picture, part.triangles, 1)
        for lines in part.lines:
            thin.extend(lines)
        thin.paint(picture)
        for points in part.points:
            paint_points(picture, points)
        changed: Array = (picture.depth != before) & (picture.depth < FAR)
        yield mark, changed


def _vector(numbers: Array) -> tuple[float, float, float]:
    x, y, z = map(float, numbers)
    return x, y, z
