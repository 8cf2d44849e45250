"""Rotations and rigid transforms as plain tuples, with the formulas of tf2's LinearMath, so that results agree to the last bit.

A quaternion is (x, y, z, w), a vector (x, y, z), a matrix nine numbers row by row, lengths are metres.
"""

from __future__ import annotations

import math

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Matrix = tuple[float, float, float, float, float, float, float, float, float]

IDENTITY: Quaternion = (0.0, 0.0, 0.0, 1.0)
ORIGIN: Vector = (0.0, 0.0, 0.0)

_NAN = (
    -math.nan if math.copysign(1.0, math.nan) > 0 else math.nan
)  # a processor's result of 0 * infinity prints as -nan


def multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the rotation that rotates by `b`, then by `a`."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by + ay * bw + az * bx - ax * bz,
        aw * bz + az * bw + ax * by - ay * bx,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """Return the inverse of a unit quaternion."""
    return (-q[0], -q[1], -q[2], q[3])


def rotate(q: Quaternion, v: Vector) -> Vector:
    """Return `v` rotated by the unit quaternion `q`."""
    x, y, z, w = q
    vx, vy, vz = v
    px = w * vx + y * vz - z * vy
    py = w * vy + z * vx - x * vz
    pz = w * vz + x * vy - y * vx
    pw = -x * vx - y * vy - z * vz
    return (
        pw * -x + px * w + py * -z - pz * -y,
        pw * -y + py * w + pz * -x - px * -z,
        pw * -z + pz * w + px * -y - py * -x,
    )


def add(a: Vector, b: Vector) -> Vector:
    """Return the sum."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def matrix(q: Quaternion) -> Matrix:
    """Return the rotation matrix of a quaternion of any length; all nan for length 0."""
    x, y, z, w = q
    square = x * x + y * y + z * z + w * w
    if square == 0.0:
        return (_NAN,) * 9
    s = 2.0 / square
    xs, ys, zs = x * s, y * s, z * s
    wx, wy, wz = w * xs, w * ys, w * zs
    xx, xy, xz = x * xs, x * ys, x * zs
    yy, yz, zz = y * ys, y * zs, z * zs
    return (1.0 - (yy + zz), xy - wz, xz + wy, xy + wz, 1.0 - (xx + zz), yz - wx, xz - wy, yz + wx, 1.0 - (xx + yy))


def quaternion(m: Matrix) -> Quaternion:
    """Return the unit quaternion of a rotation matrix: w is positive up to 120 degrees, beyond that the largest of x, y, z."""
    trace = m[0] + m[4] + m[8]
    if trace > 0.0:
        s = math.sqrt(trace + 1.0)
        w = s * 0.5
        s = 0.5 / s
        return ((m[7] - m[5]) * s, (m[2] - m[6]) * s, (m[3] - m[1]) * s, w)
    if m[0] < m[4]:
        i = 2 if m[4] < m[8] else 1
    else:
        i = 2 if m[0] < m[8] else 0
    j, k = (i + 1) % 3, (i + 2) % 3
    s = math.sqrt(m[4 * i] - m[4 * j] - m[4 * k] + 1.0)
    parts = [0.0, 0.0, 0.0]
    parts[i] = s * 0.5
    s = 0.5 / s
    parts[j] = (m[3 * j + i] + m[3 * i + j]) * s
    parts[k] = (m[3 * k + i] + m[3 * i + k]) * s
    return (parts[0], parts[1], parts[2], (m[3 * k + j] - m[3 * j + k]) * s)


def normalized(q: Quaternion) -> Quaternion:
    """Return the rotation as tf2 stores it: converted through a matrix, which normalizes its length and sign."""
    return quaternion(matrix(q))


def slerp(a: Quaternion, b: Quaternion, ratio: float) -> Quaternion:
    """Return the rotation `ratio` (0 … 1) of the way from `a` to `b`, the short way round, at constant angular velocity."""
    dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
    length = math.sqrt(sum(each * each for each in a) * sum(each * each for each in b))
    theta = math.acos(min(max(abs(dot) / length, -1.0), 1.0))
    if theta == 0.0:
        return a
    scale = 1.0 / math.sin(theta)
    s0 = math.sin((1.0 - ratio) * theta)
    s1 = math.sin(ratio * theta)
    if dot < 0:
        s1 = -s1
    return (
        (a[0] * s0 + b[0] * s1) * scale,
        (a[1] * s0 + b[1] * s1) * scale,
        (a[2] * s0 + b[2] * s1) * scale,
        (a[3] * s0 + b[3] * s1) * scale,
    )


def between(a: Vector, b: Vector, ratio: float) -> Vector:
    """Return the point `ratio` (0 … 1) of the way from `a` to `b`."""
    s = 1.0 - ratio
    return (s * a[0] + ratio * b[0], s * a[1] + ratio * b[1], s * a[2] + ratio * b[2])


def matrix_product(a: Matrix, b: Matrix) -> Matrix:
    """Return a · b."""
    rows = []
    for r in (0, 3, 6):
        x, y, z = a[r], a[r + 1], a[r + 2]
        rows += [x * b[0] + y * b[3] + z * b[6], x * b[1] + y * b[4] + z * b[7], x * b[2] + y * b[5] + z * b[8]]
    return (rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7], rows[8])


def transpose(m: Matrix) -> Matrix:
    """Return the transposed matrix, which is the inverse of a rotation matrix."""
    return (m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8])


def apply(m: Matrix, v: Vector) -> Vector:
    """Return m · v."""
    x, y, z = v
    return (
        m[0] * x + m[1] * y + m[2] * z,
        m[3] * x + m[4] * y + m[5] * z,
        m[6] * x + m[7] * y + m[8] * z,
    )


def cross(a: Vector, b: Vector) -> Vector:
    """Return the cross product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def roll_pitch_yaw(m: Matrix) -> Vector:
    """Return roll, pitch and yaw (radians) of a rotation matrix; yaw is 0 where pitch is ±90 degrees."""
    if abs(m[6]) >= 1:
        return (math.atan2(m[7], m[8]), math.copysign(math.pi / 2, -m[6]), 0.0)
    pitch = -math.asin(m[6])
    cosine = math.cos(pitch)
    return (math.atan2(m[7] / cosine, m[8] / cosine), pitch, math.atan2(m[3] / cosine, m[0] / cosine))


def from_roll_pitch_yaw(roll: float, pitch: float, yaw: float) -> Quaternion:
    """Return the rotation about the fixed axes x, y and z, in that order (radians)."""
    cr, sr = math.cos(roll * 0.5), math.sin(roll * 0.5)
    cp, sp = math.cos(pitch * 0.5), math.sin(pitch * 0.5)
    cy, sy = math.cos(yaw * 0.5), math.sin(yaw * 0.5)
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )
