"""How large what is shown is, and how much of the picture it takes."""

from __future__ import annotations

import math
from collections.abc import Sequence

from day6_core.ros.programs.rviz2.model.scene import Scene
from day6_core.ros.programs.rviz2.model.selection import bounding_box
from day6_core.ros.programs.rviz2.model.views import FIELD_OF_VIEW, Camera
from day6_urdf.model import Vector


def extent(scene: Scene) -> tuple[Vector, float] | None:
    """Centre and radius of what is visible: the robot's links if there are any, else everything but grids."""
    robot = Scene(
        shapes=[each for each in scene.shapes if each.name], triangles=[each for each in scene.triangles if each.name]
    )
    everything = Scene(
        shapes=scene.shapes,
        triangles=scene.triangles,
        points=scene.points,
        lines=[each for each in scene.lines if not each.lattice],
    )
    box = bounding_box(robot) or bounding_box(everything)
    return around([box]) if box is not None else None


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
