"""A trackball, turned by dragging it with the pointer (Ken Shoemake's arcball)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from tf_transformations._quaternions import (
    quaternion_from_matrix,
    quaternion_matrix,
    quaternion_multiply,
    quaternion_slerp,
)
from tf_transformations._vectors import EPSILON, unit_vector, vector_norm

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray


class Arcball:
    """The ball; `initial` is a quaternion or a rotation matrix. Raises ValueError for anything else."""

    def __init__(self, initial: Any = None) -> None:
        import numpy

        self._axis: Any = None
        self._axes: list[Any] | None = None
        self._radius = 1.0
        self._center = [0.0, 0.0]
        self._vdown = numpy.array([0.0, 0.0, 1.0])
        self._constrain = False
        if initial is None:
            start: Any = numpy.array([0.0, 0.0, 0.0, 1.0])
        else:
            start = numpy.array(initial, dtype=numpy.float64)
            if start.shape == (4, 4):
                start = quaternion_from_matrix(start)
            elif start.shape == (4,):
                start = unit_vector(start)
            else:
                raise ValueError("initial not a quaternion or matrix.")
        self._qdown = self._qpre = self._qnow = start

    def place(self, center: Sequence[float], radius: float) -> None:
        """Set the ball's position in the window and its radius (pixels)."""
        self._radius = float(radius)
        self._center = [center[0], center[1]]

    def setaxes(self, *axes: Any) -> None:
        """Set the axes to which rotation can be restricted."""
        self._axes = [unit_vector(axis) for axis in axes]

    def setconstrain(self, constrain: bool) -> None:
        """Set whether rotation is restricted to the axes."""
        self._constrain = constrain is True

    def getconstrain(self) -> bool:
        """Return whether rotation is restricted."""
        return self._constrain

    def down(self, point: Sequence[float]) -> None:
        """Grab the ball at a point of the window."""
        self._vdown = arcball_map_to_sphere(point, self._center, self._radius)
        self._qdown = self._qpre = self._qnow
        self._axis = None
        if self._constrain and self._axes is not None:
            self._axis = arcball_nearest_axis(self._vdown, self._axes)
            self._vdown = arcball_constrain_to_axis(self._vdown, self._axis)

    def drag(self, point: Sequence[float]) -> None:
        """Rotate the ball so that the grabbed point moves to a point of the window."""
        import numpy

        now = arcball_map_to_sphere(point, self._center, self._radius)
        if self._axis is not None:
            now = arcball_constrain_to_axis(now, self._axis)
        self._qpre = self._qnow
        turn = numpy.cross(self._vdown, now)
        if numpy.dot(turn, turn) < EPSILON:
            self._qnow = self._qdown
        else:
            self._qnow = quaternion_multiply([*turn, numpy.dot(self._vdown, now)], self._qdown)

    def next(self, acceleration: float = 0.0) -> None:
        """Continue the rotation of the last drag."""
        self._qpre, self._qnow = self._qnow, quaternion_slerp(self._qpre, self._qnow, 2.0 + acceleration, False)

    def matrix(self) -> NDArray[float64]:
        """Return the ball's rotation as a homogeneous matrix."""
        return quaternion_matrix(self._qnow)


def arcball_map_to_sphere(point: Sequence[float], center: Sequence[float], radius: float) -> NDArray[float64]:
    """Return the point of the unit ball under a point of the window; outside it, the nearest point of its rim."""
    import numpy

    x, y = (point[0] - center[0]) / radius, (center[1] - point[1]) / radius
    square = x * x + y * y
    if square > 1.0:
        return numpy.array((x, y, 0.0)) / math.sqrt(square)
    return numpy.array((x, y, math.sqrt(1.0 - square)))


def arcball_constrain_to_axis(point: Any, axis: Any) -> NDArray[float64]:
    """Return the point of the ball nearest to `point` on the circle around an axis, on the visible side."""
    import numpy

    point = numpy.array(point, dtype=numpy.float64)
    axis = numpy.array(axis, dtype=numpy.float64)
    flat: NDArray[float64] = point - axis * numpy.dot(axis, point)
    length = vector_norm(flat)
    if length > EPSILON:
        flat /= -length if flat[2] < 0.0 else length
        return flat
    if axis[2] == 1.0:
        return numpy.array([1.0, 0.0, 0.0])
    aside: NDArray[float64] = unit_vector([-axis[1], axis[0], 0.0])
    return aside


def arcball_nearest_axis(point: Any, axes: Any) -> Any:
    """Return the axis whose circle passes nearest to a point of the ball."""
    import numpy

    return max(axes, key=lambda axis: float(numpy.dot(arcball_constrain_to_axis(point, axis), point)), default=None)
