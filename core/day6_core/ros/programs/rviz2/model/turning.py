"""Rotations between their forms: matrices of three rows, quaternions x, y, z, w."""

from __future__ import annotations

from collections.abc import Sequence

from day6_urdf.model import Quaternion, Vector

Rows = tuple[Vector, Vector, Vector]


def matrix(turn: Quaternion) -> Rows:
    """The rows of the rotation matrix of a unit quaternion."""
    x, y, z, w = turn
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )


def quaternion(m: Sequence[Sequence[float]]) -> Quaternion:
    """The unit quaternion of a rotation matrix, from its largest component so that nothing cancels."""
    traces = [
        m[0][0] - m[1][1] - m[2][2],
        m[1][1] - m[0][0] - m[2][2],
        m[2][2] - m[0][0] - m[1][1],
        m[0][0] + m[1][1] + m[2][2],
    ]
    largest = max(range(4), key=traces.__getitem__)
    double = (1 + traces[largest]) ** 0.5
    parts = [0.0, 0.0, 0.0, 0.0]
    parts[largest] = double * double
    if largest == 3:
        parts[:3] = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]]
    else:
        i, j, k = largest, (largest + 1) % 3, (largest + 2) % 3
        parts[3] = m[k][j] - m[j][k]
        parts[j], parts[k] = m[j][i] + m[i][j], m[k][i] + m[i][k]
    x, y, z, w = (part / (2 * double) for part in parts)
    return x, y, z, w
