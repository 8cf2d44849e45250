"""How a control of an interactive marker follows the keys, in the marker's reference frame.

A key moves along that axis of the frame which lies nearest to its direction in the picture, so that coordinates stay round.
"""

from __future__ import annotations

from typing import NamedTuple

from day6_core.ros.programs.rviz2.model.displays.control_drag import Eye, dot, plus
from day6_core.ros.programs.rviz2.model.displays.control_shapes import (
    MOVE_3D,
    MOVE_AXIS,
    MOVE_PLANE,
    MOVE_ROTATE,
    MOVE_ROTATE_3D,
    ROTATE_3D,
    ROTATE_AXIS,
)
from day6_urdf.kinematics import Transform, about, multiply
from day6_urdf.model import Vector

BOTH = (MOVE_ROTATE, MOVE_ROTATE_3D)
"""Controls that move and turn."""

_XYZ = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Steps(NamedTuple):
    """Keys: to the right, up and away from the viewer, one of them not 0; what one of them moves and turns."""

    right: int
    up: int
    away: int
    metres: float
    radians: float


class Axes(NamedTuple):
    """A control's axis, about which it turns or along which it moves, and the two that span its plane."""

    main: Vector
    plane: tuple[Vector, Vector]


def turns(mode: int, turning: bool) -> bool:
    """Whether the keys turn a control; `turning` decides for those that do both."""
    return mode in (ROTATE_AXIS, ROTATE_3D) or (mode in BOTH and turning)


def stepped(mode: int, pose: Transform, axes: Axes, eye: Eye, steps: Steps, turning: bool) -> tuple[Transform, float]:
    """The marker's new pose, and the radians turned about the control's axis."""
    if turns(mode, turning):
        if mode in (ROTATE_AXIS, MOVE_ROTATE):
            angle = _clockwise(axes.main, eye) * (steps.right + steps.up + steps.away) * steps.radians
            return _turned(pose, axes.main, angle), angle
        right, up, away = _nearest(eye, _XYZ)
        turn = _turned(_turned(pose, up, steps.right * steps.radians), right, -steps.up * steps.radians)
        return _turned(turn, away, steps.away * steps.radians), 0.0
    if mode == MOVE_AXIS:
        asked = plus(plus(_scaled(eye.right, steps.right), _upward(eye), steps.up), eye.forward, steps.away)
        way = 1 if dot(asked, axes.main) >= -1e-6 else -1
        return _moved(pose, axes.main, way * steps.metres), 0.0
    if mode in (MOVE_PLANE, MOVE_ROTATE):
        right, up = _nearest_two(eye, axes.plane)
        return _moved(_moved(pose, right, steps.right * steps.metres), up, (steps.up + steps.away) * steps.metres), 0.0
    if mode in (MOVE_3D, MOVE_ROTATE_3D):
        for axis, count in zip(_nearest(eye, _XYZ), (steps.right, steps.up, steps.away), strict=True):
            pose = _moved(pose, axis, count * steps.metres)
    return pose, 0.0


def _nearest(eye: Eye, axes: tuple[Vector, Vector, Vector]) -> tuple[Vector, Vector, Vector]:
    """Those of three axes, or their opposites, that look to the right, up and away."""
    right = max(axes, key=lambda axis: abs(dot(axis, eye.right)))
    others = [axis for axis in axes if axis is not right]
    up = max(others, key=lambda axis: abs(dot(axis, eye.up)))
    (away,) = (axis for axis in others if axis is not up)
    return _along(right, eye.right), _along(up, eye.up), _along(away, eye.forward)


def _nearest_two(eye: Eye, axes: tuple[Vector, Vector]) -> tuple[Vector, Vector]:
    """Those of two axes, or their opposites, that look to the right and up (or away, in a plane seen from its edge)."""
    first, second = sorted(axes, key=lambda axis: -abs(dot(axis, eye.right)))
    return _along(first, eye.right), _along(second, _upward(eye))


def _upward(eye: Eye) -> Vector:
    """What is up in the picture, for a camera that looks down, too."""
    return plus(eye.up, eye.forward, 1.0)


def _along(axis: Vector, direction: Vector) -> Vector:
    return axis if dot(axis, direction) >= 0 else _scaled(axis, -1.0)


def _clockwise(axis: Vector, eye: Eye) -> int:
    """The sense in which one turns about an axis to turn clockwise as it is seen."""
    return 1 if dot(axis, eye.forward) > 0 else -1


def _scaled(a: Vector, factor: float) -> Vector:
    return a[0] * factor, a[1] * factor, a[2] * factor


def _moved(pose: Transform, along: Vector, metres: float) -> Transform:
    x, y, z = (round(part, 9) for part in plus(pose.xyz, along, metres))
    return Transform((x, y, z), pose.rotation)


def _turned(pose: Transform, axis: Vector, angle: float) -> Transform:
    return Transform(pose.xyz, multiply(about(axis, angle), pose.rotation)) if angle else pose
