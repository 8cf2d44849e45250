"""How large what is shown is, and how much of the picture it takes."""

from __future__ import annotations

import math
from collections.abc import Sequence

from day6_tui.core.ros.programs.rviz2.model.scene import Scene, placed
from day6_tui.core.ros.programs.rviz2.model.views import FIELD_OF_VIEW, Camera
from day6_tui.urdf.model import Vector


def extent(scene: Scene) -> tuple[Vector, float] | None:
    """Centre and radius of what is visible: the robot's links if there are any, else all solids and points."""
    shapes = [shape for shape in scene.shapes if shape.name] or ([] if scene.triangles else scene.shapes)
    low, high = [math.inf] * 3, [-math.inf] * 3

    def take(centre: Vector, radius: float) -> None:
        for axis in range(3):
            low[axis] = min(low[axis], centre[axis] - radius)
            high[axis] = max(high[axis], centre[axis] + radius)

    for shape in shapes:
        half = [size / 2 for size in shape.size]
        for signs in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            for sign in (1, -1):
                corner = (sign * half[0], signs[0] * half[1], signs[1] * half[2])
                take(placed(shape.pose, corner), 0.0)
    for mesh in scene.triangles:
        corners = (
            (abs(mesh.vertices).max(axis=0) * [abs(part) for part in mesh.scale]) if len(mesh.vertices) else (0, 0, 0)
        )
        take(mesh.pose.xyz, float(math.dist((0, 0, 0), tuple(corners))))
    if not all(map(math.isfinite, (*low, *high))):
        return None
    return around([((low[0], low[1], low[2]), (high[0], high[1], high[2]))])


def around(boxes: Sequence[tuple[Vector, Vector]]) -> tuple[Vector, float] | None:
    """Centre and radius of a ball around boxes, each given by its least and greatest corner; None for no box."""
    if not boxes:
        return None
    low = [min(box[0][axis] for box in boxes) for axis in range(3)]
    high = [max(box[1][axis] for box in boxes) for axis in range(3)]
    centre = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2)
    return centre, max(1e-3, math.dist(low, high) / 2)


def share_of_picture(camera: Camera, centre: Vector, radius: float, aspect: float) -> float:
    """The part of the picture (`aspect` times as wide as high) that a ball takes, across its shorter side."""
    if camera.metres is not None:
        metres = camera.metres
    else:
        depth = sum((a - b) * c for a, b, c in zip(centre, camera.position, camera.forward, strict=True))
        metres = 2 * max(depth, camera.near) * math.tan(FIELD_OF_VIEW / 2)
    return 2 * radius / (metres * min(1.0, max(aspect, 0.01)))
