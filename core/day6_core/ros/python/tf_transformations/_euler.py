"""Euler angles about any of the 24 sequences of axes, after Ken Shoemake (Graphics Gems IV, "Euler Angle Conversion").

A sequence is a word such as `sxyz`: s for static axes, r for rotating axes, then the three axes. Its tuple has the innermost
axis, the parity of the axes' order, whether the last axis is the first again, and whether the axes rotate.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray

Axes = str | tuple[int, int, int, int]

_EPSILON = 4.0 * 2.220446049250313e-16


def _sequences() -> dict[str, tuple[int, int, int, int]]:
    table = {}
    for turning in (0, 1):
        for first in range(3):
            for odd in (0, 1):
                for repeated in (0, 1):
                    second = (first + 1 + odd) % 3
                    third = first if repeated else 3 - first - second
                    word = "".join("xyz"[axis] for axis in (first, second, third))
                    table["r" + word[::-1] if turning else "s" + word] = (first, odd, repeated, turning)
    return table


AXES_TO_TUPLE = _sequences()
TUPLE_TO_AXES = {value: key for key, value in AXES_TO_TUPLE.items()}


def _order(axes: Axes) -> tuple[int, int, int, bool, bool, bool]:
    """Return the axes i, j, k and whether their order is odd, repeated, turning. Raises KeyError for an unknown sequence."""
    if isinstance(axes, str):
        first, odd, repeated, turning = AXES_TO_TUPLE[axes.lower()]
    else:
        first, odd, repeated, turning = AXES_TO_TUPLE[TUPLE_TO_AXES[axes]]
    second = (first + 1 + odd) % 3
    return first, second, 3 - first - second, bool(odd), bool(repeated), bool(turning)


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> tuple[float, float, float, float]:
    """Return the quaternion (x, y, z, w) of Euler angles (radians); by default roll, pitch, yaw. Raises KeyError."""
    i, j, k, odd, repeated, turning = _order(axes)
    if turning:
        ai, ak = ak, ai
    if odd:
        aj = -aj
    ci, si = math.cos(ai / 2.0), math.sin(ai / 2.0)
    cj, sj = math.cos(aj / 2.0), math.sin(aj / 2.0)
    ck, sk = math.cos(ak / 2.0), math.sin(ak / 2.0)
    cc, cs, sc, ss = ci * ck, ci * sk, si * ck, si * sk
    q = [0.0, 0.0, 0.0]
    if repeated:
        w = cj * (cc - ss)
        q[i], q[j], q[k] = cj * (cs + sc), sj * (cc + ss), sj * (cs - sc)
    else:
        w = cj * cc + sj * ss
        q[i], q[j], q[k] = cj * sc - sj * cs, cj * ss + sj * cc, cj * cs - sj * sc
    if odd:
        q[j] = -q[j]
    return q[0], q[1], q[2], w


def rotation_rows(quaternion: Sequence[float]) -> list[list[float]]:
    """Return the rotation matrix of a quaternion of any length as three rows; length 0 gives the identity."""
    x, y, z, w = quaternion
    square = w * w + x * x + y * y + z * z
    if square < _EPSILON / 4.0:
        return [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    s = 2.0 / square
    xs, ys, zs = x * s, y * s, z * s
    return [
        [1.0 - (y * ys + z * zs), x * ys - w * zs, x * zs + w * ys],
        [x * ys + w * zs, 1.0 - (x * xs + z * zs), y * zs - w * xs],
        [x * zs - w * ys, y * zs + w * xs, 1.0 - (x * xs + y * ys)],
    ]


def _angles(m: Any, axes: Axes) -> tuple[float, float, float]:
    """Return the Euler angles of a rotation given as rows, m[row][column]."""
    i, j, k, odd, repeated, turning = _order(axes)
    if repeated:
        away = math.sqrt(m[i][j] * m[i][j] + m[i][k] * m[i][k])
        first, third = math.atan2(m[i][j], m[i][k]), math.atan2(m[j][i], -m[k][i])
        second = math.atan2(away, m[i][i])
    else:
        away = math.sqrt(m[i][i] * m[i][i] + m[j][i] * m[j][i])
        first, third = math.atan2(m[k][j], m[k][k]), math.atan2(m[j][i], m[i][i])
        second = math.atan2(-m[k][i], away)
    if away <= _EPSILON:  # gimbal lock: only the sum of the outer angles is known
        first, third = math.atan2(-m[j][k], m[j][j]), 0.0
    if odd:
        first, second, third = -first, -second, -third
    return (third, second, first) if turning else (first, second, third)


def euler_from_matrix(matrix: Any, axes: Axes = "sxyz") -> tuple[float, float, float]:
    """Return Euler angles (radians) of a rotation, shape (3, 3) or (4, 4). Raises KeyError for unknown axes."""
    return _angles([[float(matrix[row][column]) for column in range(3)] for row in range(3)], axes)


def euler_from_quaternion(quaternion: Sequence[float], axes: Axes = "sxyz") -> tuple[float, float, float]:
    """Return Euler angles (radians), by default roll, pitch, yaw, of a quaternion (x, y, z, w). Raises KeyError."""
    # Adding 0.0 removes negative zeros, which would change the sign of an angle.
    return _angles([[float(value) + 0.0 for value in row] for row in rotation_rows(quaternion)], axes)


def rotation_from_euler(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> NDArray[float64]:
    """Return the rotation matrix, shape (3, 3), of Euler angles (radians)."""
    import numpy

    i, j, k, odd, repeated, turning = _order(axes)
    if turning:
        ai, ak = ak, ai
    if odd:
        ai, aj, ak = -ai, -aj, -ak
    si, sj, sk = math.sin(ai), math.sin(aj), math.sin(ak)
    ci, cj, ck = math.cos(ai), math.cos(aj), math.cos(ak)
    cc, cs, sc, ss = ci * ck, ci * sk, si * ck, si * sk
    m = numpy.identity(3)
    if repeated:
        m[i, [i, j, k]] = cj, sj * si, sj * ci
        m[j, [i, j, k]] = sj * sk, -cj * ss + cc, -cj * cs - sc
        m[k, [i, j, k]] = -sj * ck, cj * sc + cs, cj * cc - ss
    else:
        m[i, [i, j, k]] = cj * ck, sj * sc - cs, sj * cc + ss
        m[j, [i, j, k]] = cj * sk, sj * ss + cc, sj * cs - sc
        m[k, [i, j, k]] = -sj, cj * si, cj * ci
    return m


def euler_matrix(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> NDArray[float64]:
    """Return the homogeneous matrix of Euler angles (radians). Raises KeyError for unknown axes."""
    import numpy

    matrix = numpy.identity(4)
    matrix[:3, :3] = rotation_from_euler(ai, aj, ak, axes)
    return matrix
