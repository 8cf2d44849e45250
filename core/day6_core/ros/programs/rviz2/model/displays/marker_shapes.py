"""The shapes of each type of visualization_msgs/Marker."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any

from day6_core.ros.programs.rviz2.model.scene import (
    BOX,
    CYLINDER,
    SPHERE,
    Colour,
    Label,
    Lines,
    Points,
    Scene,
    Shape,
    Triangles,
    placed,
    pointing,
)
from day6_core.ros.programs.rviz2.model.topics import pose_of
from day6_urdf.kinematics import Transform, compose
from day6_urdf.model import Vector

(
    ARROW,
    CUBE,
    SPHERE_TYPE,
    CYLINDER_TYPE,
    LINE_STRIP,
    LINE_LIST,
    CUBE_LIST,
    SPHERE_LIST,
    POINTS,
    TEXT,
    MESH,
    TRIANGLES,
) = range(12)

WARN_SCALE = "Scale of 0 in one of x/y/z"

_GREY = (0.7, 0.7, 0.7)

MOST_SOLIDS = 1000
"""Of a list of cubes or spheres; the rest is drawn as points."""


def problem_of(marker: Any) -> str:
    """The original's message about a marker that it cannot draw, or not well; '' if there is none."""
    scale = marker.scale
    key = f"{marker.ns}/{marker.id}"
    kind = marker.type
    if kind == ARROW and len(marker.points) == 1:
        return f"Arrow marker [{key}] only specified one point of a point to point arrow."
    if kind == ARROW and len(marker.points) >= 2:
        return "Scale of 0 in both x and y" if scale.x == 0 and scale.y == 0 else ""
    if kind in (ARROW, CUBE, SPHERE_TYPE, CYLINDER_TYPE, TRIANGLES) and 0 in (scale.x, scale.y, scale.z):
        return WARN_SCALE
    if kind == LINE_LIST and len(marker.points) % 2:
        return f"Line list marker [{key}] has an odd number of points."
    if kind == TRIANGLES and not marker.points:
        return f"TriMesh marker [{key}] has no points."
    if kind == TRIANGLES and len(marker.points) % 3:
        return f"TriMesh marker [{key}] has a point count which is not divisible by 3 [{len(marker.points)}]"
    return ""


def draw_marker(scene: Scene, marker: Any, frame: Transform, mesh: Any = None) -> None:
    """Add a marker to the scene; `frame` is the pose of its frame, `mesh` the data of its mesh as soon as it is read."""
    if marker.type == MESH:
        if mesh is not None:
            colours = mesh.colours if marker.mesh_use_embedded_materials else None
            pose = compose(frame, pose_of(marker.pose))
            colour = (*_GREY, 1.0) if marker.mesh_use_embedded_materials else _colour(marker)
            scene.triangles.append(Triangles(mesh.vertices, mesh.faces, pose, _size(marker), colour, colours))
        return
    draw = _DRAW.get(marker.type)
    if draw is not None:
        draw(scene, marker, compose(frame, pose_of(marker.pose)))


def _colour(marker: Any) -> Colour:
    colour = marker.color
    return colour.r, colour.g, colour.b, colour.a


def _colours(marker: Any, count: int) -> list[Colour]:
    if len(marker.colors) == count and count:
        return [(each.r, each.g, each.b, each.a) for each in marker.colors]
    return [_colour(marker)]


def _points(marker: Any) -> list[Vector]:
    return [(point.x, point.y, point.z) for point in marker.points]


def _size(marker: Any) -> Vector:
    return marker.scale.x, marker.scale.y, marker.scale.z


def _solid(kind: str) -> Callable[[Scene, Any, Transform], None]:
    def draw(scene: Scene, marker: Any, pose: Transform) -> None:
        scene.shapes.append(Shape(kind, pose, _size(marker), _colour(marker)))

    return draw


def _arrow(scene: Scene, marker: Any, pose: Transform) -> None:
    points = _points(marker)
    x, y, z = _size(marker)
    colour = _colour(marker)
    if len(points) == 1:
        return
    if len(points) >= 2:
        start, end = placed(pose, points[0]), placed(pose, points[1])
        length = math.dist(start, end)
        # scale.x is the shaft's diameter, y the head's, z the head's length (0: a quarter of the whole).
        head = min(z if z else 0.23 * length, length)
        scene.arrow(pointing(start, end), length - head, x, head, y, colour)
    else:
        scene.arrow(pose, 0.77 * x, y, 0.23 * x, 2 * y, colour)


def _strip(scene: Scene, marker: Any, pose: Transform) -> None:
    points = _points(marker)
    colours = _colours(marker, len(points))
    ends = [point for pair in pairwise(points) for point in pair]
    if len(colours) > 1:
        colours = [colour for pair in pairwise(colours) for colour in pair]
    if ends:
        scene.lines.append(Lines(ends, colours, pose, marker.scale.x))


def _line_list(scene: Scene, marker: Any, pose: Transform) -> None:
    points = _points(marker)
    if points and len(points) % 2 == 0:
        scene.lines.append(Lines(points, _colours(marker, len(points)), pose, marker.scale.x))


def _solids(kind: str) -> Callable[[Scene, Any, Transform], None]:
    def draw(scene: Scene, marker: Any, pose: Transform) -> None:
        points = _points(marker)
        colours = _colours(marker, len(points))
        for index, point in enumerate(points[:MOST_SOLIDS]):
            place = compose(pose, Transform(point))
            scene.shapes.append(Shape(kind, place, _size(marker), colours[index % len(colours)]))
        if rest := points[MOST_SOLIDS:]:
            tints = colours[MOST_SOLIDS:] if len(colours) > 1 else colours
            scene.points.append(Points(rest, tints, max(_size(marker)), pose))

    return draw


def _point_cloud(scene: Scene, marker: Any, pose: Transform) -> None:
    points = _points(marker)
    if points:
        scene.points.append(Points(points, _colours(marker, len(points)), max(marker.scale.x, marker.scale.y), pose))


def _text(scene: Scene, marker: Any, pose: Transform) -> None:
    if marker.text.strip():
        scene.labels.append(Label(marker.text, pose.xyz, _colour(marker)))


def _triangles(scene: Scene, marker: Any, pose: Transform) -> None:
    import numpy as np

    points = _points(marker)
    if not points or len(points) % 3:
        return
    faces = np.arange(len(points)).reshape(-1, 3)
    colours = None
    if len(marker.colors) in (len(points), len(points) // 3):
        every = 3 if len(marker.colors) == len(points) else 1
        colours = np.array([(each.r, each.g, each.b) for each in marker.colors[::every]])
    scene.triangles.append(Triangles(np.array(points), faces, pose, _size(marker), _colour(marker), colours))


_DRAW: dict[int, Callable[[Scene, Any, Transform], None]] = {
    ARROW: _arrow,
    CUBE: _solid(BOX),
    SPHERE_TYPE: _solid(SPHERE),
    CYLINDER_TYPE: _solid(CYLINDER),
    LINE_STRIP: _strip,
    LINE_LIST: _line_list,
    CUBE_LIST: _solids(BOX),
    SPHERE_LIST: _solids(SPHERE),
    POINTS: _point_cloud,
    TEXT: _text,
    TRIANGLES: _triangles,
}
"""Of every type but MESH_RESOURCE, which needs its mesh."""
