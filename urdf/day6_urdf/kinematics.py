"""Forward kinematics in plain Python (for a robot's few links numpy is not faster).

A transform is a `Transform(xyz, rotation)`: metres, and a unit quaternion x, y, z, w, as in tf; `matrix` returns the 4x4 rows.
Joint positions are radians for revolute and continuous joints, metres for prismatic ones; axes are normalised as in KDL, so a
prismatic axis of length 2 moves one metre per metre.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from day6_urdf.model import MOVING_TYPES, Joint, Pose, Quaternion, Robot, Vector

Matrix = tuple[
    tuple[float, float, float, float],
    tuple[float, float, float, float],
    tuple[float, float, float, float],
    tuple[float, float, float, float],
]
Transform = Pose
IDENTITY = Transform()


def multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the rotation b followed by a."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def rotate(rotation: Quaternion, vector: Vector) -> Vector:
    """Return the vector rotated by a unit quaternion."""
    x, y, z, w = rotation
    vx, vy, vz = vector
    tx, ty, tz = 2 * (y * vz - z * vy), 2 * (z * vx - x * vz), 2 * (x * vy - y * vx)
    return (
        vx + w * tx + y * tz - z * ty,
        vy + w * ty + z * tx - x * tz,
        vz + w * tz + x * ty - y * tx,
    )


def compose(parent: Transform, child: Transform) -> Transform:
    """Return the transform of `child`, given in `parent`'s frame, in the frame in which `parent` is given."""
    x, y, z = rotate(parent.rotation, child.xyz)
    px, py, pz = parent.xyz
    return Transform((px + x, py + y, pz + z), multiply(parent.rotation, child.rotation))


def inverse(transform: Transform) -> Transform:
    """Return the inverse transform: that of the parent in the child's frame."""
    x, y, z, w = transform.rotation
    back = (-x, -y, -z, w)
    px, py, pz = rotate(back, transform.xyz)
    return Transform((-px, -py, -pz), back)


def about(axis: Vector, angle: float) -> Quaternion:
    """Return the rotation by `angle` (radians) about `axis`, the identity for an axis of length 0."""
    length = math.sqrt(axis[0] ** 2 + axis[1] ** 2 + axis[2] ** 2)
    if length == 0:
        return 0.0, 0.0, 0.0, 1.0
    sine = math.sin(angle / 2) / length
    return axis[0] * sine, axis[1] * sine, axis[2] * sine, math.cos(angle / 2)


def joint_transform(joint: Joint, position: float) -> Transform:
    """Return the child link's transform in the parent link at a position (radians or metres).

    Fixed, floating and planar joints stay at their origin.
    """
    if joint.type in ("revolute", "continuous"):
        return Transform(joint.origin.xyz, multiply(joint.origin.rotation, about(joint.axis, position)))
    if joint.type == "prismatic":
        x, y, z = joint.axis
        length = math.sqrt(x * x + y * y + z * z)
        if length == 0:
            return joint.origin
        step = position / length
        return compose(joint.origin, Transform((x * step, y * step, z * step)))
    return joint.origin


def positions_with_mimics(robot: Robot, positions: Mapping[str, float]) -> dict[str, float]:
    """Return the given positions (radians or metres) and those of joints that mimic them, directly or through other mimics."""
    known = dict(positions)
    for joint in robot.joints:
        chain: list[Joint] = []
        follower = joint
        while follower.mimic is not None and follower.name not in known and follower not in chain:
            chain.append(follower)
            if not robot.has_joint(follower.mimic.joint):
                break
            follower = robot.joint(follower.mimic.joint)
        for follower in reversed(chain):
            mimic = follower.mimic
            if mimic is not None and mimic.joint in known:
                known[follower.name] = mimic.multiplier * known[mimic.joint] + mimic.offset
    return known


def link_transforms(robot: Robot, positions: Mapping[str, float]) -> dict[str, Transform]:
    """Return the transform of every link in the root link's frame; joints without a position are at 0."""
    standing = {joint.name: 0.0 for joint in robot.joints if joint.mimic is None}
    known = positions_with_mimics(robot, {**standing, **positions})
    transforms = {robot.root: IDENTITY}
    for joint in robot.tree():
        transforms[joint.child] = compose(transforms[joint.parent], joint_transform(joint, known.get(joint.name, 0.0)))
    return transforms


def matrix(transform: Transform) -> Matrix:
    """Return the homogeneous 4x4 matrix as four rows."""
    x, y, z, w = transform.rotation
    px, py, pz = transform.xyz
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), px),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), py),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), pz),
        (0.0, 0.0, 0.0, 1.0),
    )


def canonical(rotation: Quaternion) -> Quaternion:
    """Return the same rotation with KDL's sign (robot_state_publisher gets its quaternions from KDL).

    KDL computes it from the matrix: with a positive trace w is positive, else the largest of x, y, z is.
    """
    x, y, z, w = rotation
    if 3 * w * w - x * x - y * y - z * z > 1e-12:
        leading = w
    elif x * x > y * y and x * x > z * z:
        leading = x
    elif y * y > z * z:
        leading = y
    else:
        leading = z
    return (-x, -y, -z, -w) if leading < 0 else rotation


def is_moving(joint: Joint) -> bool:
    """Return whether robot_state_publisher moves this joint (revolute, continuous, prismatic)."""
    return joint.type in MOVING_TYPES
