"""How large what is shown is, how much of the picture it takes, and how to let it take as much as there is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from day6_core.ros.programs.rviz2.model.scene import Scene
from day6_core.ros.programs.rviz2.model.selection import corners_of
from day6_core.ros.programs.rviz2.model.views import FIELD_OF_VIEW, Camera, View
from day6_urdf.model import Vector

SMALL = 0.25
"""What takes less than this part of the picture's width and of its height is a speck."""

FILL, TOLERANCE = 0.9, 0.03
"""The part of the picture that is filled by what is looked at, and how much more it may be."""

ROUNDS, CAUTION = 16, 0.6
"""Steps in which the camera comes to where it fills so much, each somewhat shorter than what seems to be missing: what is near
grows faster than the way to it shrinks."""

POINT, ROOM = 1e-3, 0.5
"""What has no larger radius, in metres, is a point, and as much of what is around it is shown."""


def robot_of(scene: Scene) -> Scene:
    """The links of the robots in it."""
    return Scene(
        shapes=[each for each in scene.shapes if each.name], triangles=[each for each in scene.triangles if each.name]
    )


def outline(scene: Scene) -> list[Vector]:
    """Points that what is visible lies between: those of the robot's links if there are any, else of everything but grids."""
    everything = Scene(
        shapes=scene.shapes,
        triangles=scene.triangles,
        points=scene.points,
        lines=[each for each in scene.lines if not each.lattice],
    )
    return corners_of(robot_of(scene)) or corners_of(everything)


def ball(points: Sequence[Vector]) -> tuple[Vector, float]:
    """Centre and radius of a ball around points, of which there must be one."""
    low, high = ([least(point[axis] for point in points) for axis in range(3)] for least in (min, max))
    centre = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2)
    return centre, max(POINT, math.dist(low, high) / 2)


class _Span(NamedTuple):
    """What points cover of a picture, whose edges are at -1 and 1: its middle, and how far it reaches from there."""

    x: float
    y: float
    across: float
    along: float

    @property
    def farthest(self) -> float:
        """How far it reaches from the middle of the picture."""
        return max(abs(self.x) + self.across, abs(self.y) + self.along)


def _span(camera: Camera, points: Sequence[Vector], aspect: float) -> _Span | None:
    """What points cover of a picture `aspect` times as wide as high; None if one is not before the camera."""
    away = np.asarray(points, np.float64) - np.array(camera.position)
    x, y, depth = np.array([camera.right, camera.up, camera.forward]) @ away.T
    if depth.min() <= camera.near:
        return None
    half = depth * math.tan(FIELD_OF_VIEW / 2) if camera.metres is None else np.full(len(depth), camera.metres / 2)
    across, along = x / half / aspect, y / half
    left, right, low, high = (float(each) for each in (across.min(), across.max(), along.min(), along.max()))
    return _Span((left + right) / 2, (low + high) / 2, (right - left) / 2, (high - low) / 2)


def is_speck(camera: Camera, points: Sequence[Vector], aspect: float) -> bool:
    """Whether what lies between points is hardly seen in a picture `aspect` times as wide as high, or not at all."""
    middle, span = _span(camera, [ball(points)[0]], aspect), _span(camera, points, aspect)
    if middle is None or abs(middle.x) > 1 or abs(middle.y) > 1:
        return True
    return span is not None and max(span.across, span.along) < SMALL


def frame(view: View, points: Sequence[Vector], aspect: float) -> None:
    """Let what lies between points fill a picture that is `aspect` times as wide as high, seen from the same direction."""
    centre, radius = ball(points)
    is_point = radius <= POINT
    radius = (ROOM if is_point else radius) / min(1.0, max(0.2, aspect))
    best, fills = (centre, radius), 0.0
    view.look_at(*best)
    for _ in range(0 if is_point else ROUNDS):
        camera = view.camera()
        span = _span(camera, points, aspect)
        if span is None:  # it came too near
            radius *= 2
        else:
            if fills < span.farthest <= FILL + TOLERANCE:
                best, fills = (centre, radius), span.farthest
            centre = _moved(camera, centre, span.x * aspect * CAUTION, span.y * CAUTION)
            radius *= max(0.5, min(2.0, (span.farthest / FILL) ** CAUTION))
        view.look_at(centre, radius)
    view.look_at(*best)


def _moved(camera: Camera, centre: Vector, across: float, along: float) -> Vector:
    """A point moved to the right and up, in halves of the picture's height: what is near reaches farther from its middle."""
    depth = sum((a - b) * c for a, b, c in zip(centre, camera.position, camera.forward, strict=True))
    half = depth * math.tan(FIELD_OF_VIEW / 2) if camera.metres is None else camera.metres / 2
    x, y, z = (
        place + half * (right * across + up * along)
        for place, right, up in zip(centre, camera.right, camera.up, strict=True)
    )
    return x, y, z
