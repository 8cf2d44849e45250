"""Quaternions (x, y, z, w)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from tf_transformations._euler import rotation_rows
from tf_transformations._vectors import EPSILON, unit_vector

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray


def quaternion_about_axis(angle: float, axis: Sequence[float]) -> tuple[float, float, float, float]:
    """Return the rotation by an angle (radians) about an axis of any length."""
    x, y, z = axis
    scale = math.sin(angle / 2.0) / math.sqrt(x * x + y * y + z * z)
    return (x * scale, y * scale, z * scale, math.cos(angle / 2.0))


def quaternion_matrix(quaternion: Sequence[float]) -> NDArray[float64]:
    """Return the homogeneous matrix of a rotation."""
    import numpy

    matrix = numpy.identity(4)
    matrix[:3, :3] = numpy.array(rotation_rows(quaternion)) + 0.0
    return matrix


def quaternion_from_matrix(matrix: Any) -> tuple[float, float, float, float]:
    """Return the rotation in a homogeneous matrix, with w not negative; scale and shear do not matter.

    It is the largest eigenvector of a symmetric matrix of its elements (Bar-Itzhack, "New method for extracting the quaternion
    from a rotation matrix", 2000). Raises numpy.linalg.LinAlgError for a singular matrix.
    """
    import numpy

    from tf_transformations._matrices import split

    m = split(matrix)[1]
    k = numpy.zeros((4, 4))
    k[0, 0] = m[0, 0] - m[1, 1] - m[2, 2]
    k[1, :2] = m[0, 1] + m[1, 0], m[1, 1] - m[0, 0] - m[2, 2]
    k[2, :3] = m[2, 0] + m[0, 2], m[1, 2] + m[2, 1], m[2, 2] - m[0, 0] - m[1, 1]
    k[3, :] = m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], m[0, 0] + m[1, 1] + m[2, 2]
    values, vectors = numpy.linalg.eigh(k / 3.0)
    x, y, z, w = (float(part) for part in vectors[:, numpy.argmax(values)])
    return (-x, -y, -z, -w) if w < 0 else (x, y, z, w)


def quaternion_multiply(
    quaternion1: Sequence[float], quaternion0: Sequence[float]
) -> tuple[float, float, float, float]:
    """Return the product: the rotation by `quaternion0`, then by `quaternion1`."""
    x0, y0, z0, w0 = quaternion0
    x1, y1, z1, w1 = quaternion1
    return (
        w1 * x0 + x1 * w0 + y1 * z0 - z1 * y0,
        w1 * y0 + y1 * w0 + z1 * x0 - x1 * z0,
        w1 * z0 + z1 * w0 + x1 * y0 - y1 * x0,
        w1 * w0 - x1 * x0 - y1 * y0 - z1 * z0,
    )


def quaternion_conjugate(quaternion: Sequence[float]) -> NDArray[float64]:
    """Return the conjugate, which is the inverse of a unit quaternion."""
    import numpy

    x, y, z, w = quaternion[0], quaternion[1], quaternion[2], quaternion[3]
    return numpy.array((-x, -y, -z, w), dtype=numpy.float64)


def quaternion_inverse(quaternion: Sequence[float]) -> NDArray[float64]:
    """Return the inverse."""
    import numpy

    inverse: NDArray[float64] = quaternion_conjugate(quaternion) / numpy.dot(quaternion, quaternion)
    return inverse


def quaternion_slerp(
    quat0: Sequence[float], quat1: Sequence[float], fraction: float, spin: float = 0, shortestpath: bool = True
) -> NDArray[float64]:
    """Return the rotation at a fraction of the way from `quat0` to `quat1`, with `spin` additional half turns."""
    import numpy

    q0: NDArray[float64] = unit_vector(quat0[:4])
    q1: NDArray[float64] = unit_vector(quat1[:4])
    cosine = float(numpy.dot(q0, q1))
    if fraction == 0.0:
        return q0
    if fraction == 1.0:
        return q1
    if abs(abs(cosine) - 1.0) < EPSILON:
        return q0
    if shortestpath and cosine < 0.0:
        cosine, q1 = -cosine, -q1
    angle = math.acos(cosine) + spin * math.pi
    if abs(angle) < EPSILON:
        return q0
    scale = 1.0 / math.sin(angle)
    return q0 * (math.sin((1.0 - fraction) * angle) * scale) + q1 * (math.sin(fraction * angle) * scale)


def random_quaternion(rand: Any = None) -> NDArray[float64]:
    """Return a uniformly distributed random rotation, from three numbers between 0 and 1 (by default random ones)."""
    import numpy

    if rand is None:
        rand = numpy.random.rand(3)
    assert len(rand) == 3
    near, far = math.sqrt(1.0 - rand[0]), math.sqrt(rand[0])
    first, second = 2.0 * math.pi * rand[1], 2.0 * math.pi * rand[2]
    return numpy.array(
        (math.sin(first) * near, math.cos(first) * near, math.sin(second) * far, math.cos(second) * far),
        dtype=numpy.float64,
    )


def random_rotation_matrix(rand: Any = None) -> NDArray[float64]:
    """Return the homogeneous matrix of `random_quaternion`."""
    return quaternion_matrix(random_quaternion(rand))  # type: ignore[arg-type]
