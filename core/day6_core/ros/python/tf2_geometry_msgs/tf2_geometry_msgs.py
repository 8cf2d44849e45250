"""Transforms the stamped types of geometry_msgs and registers these functions with tf2_ros.

The real package uses numpy arrays; here a few multiplications do, which need no import.
"""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import (
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovariance,
    PoseWithCovarianceStamped,
    Quaternion,
    TransformStamped,
    Vector3Stamped,
)
from tf2_py import _rotation as rot
from tf2_ros.buffer_interface import ConvertRegistration, TransformRegistration

_EPSILON = 2.220446049250313e-16


def to_msg_msg(msg: Any) -> Any:
    """Return the message itself: it needs no conversion."""
    return msg


def from_msg_msg(msg: Any) -> Any:
    """Return the message itself: it needs no conversion."""
    return msg


for _type in (Vector3Stamped, PoseStamped, PointStamped):
    ConvertRegistration().add_to_msg(_type, to_msg_msg)
    ConvertRegistration().add_from_msg(_type, from_msg_msg)


def _turn(quaternion: Quaternion) -> rot.Quaternion:
    """Return a rotation; a quaternion of length 0 counts as the identity."""
    turn = (quaternion.x, quaternion.y, quaternion.z, quaternion.w)
    return rot.IDENTITY if sum(each * each for each in turn) < _EPSILON else turn


def _moved(transform: TransformStamped, x: float, y: float, z: float) -> rot.Vector:
    offset = transform.transform.translation
    turned = rot.apply(rot.matrix(_turn(transform.transform.rotation)), (x, y, z))
    return rot.add(turned, (offset.x, offset.y, offset.z))


def transform_covariance(cov_in: Any, transform: TransformStamped) -> Any:
    """Return a 6x6 covariance (36 numbers: x, y, z, rotations about x, y, z) in the axes of the target frame."""
    rotation = transform.transform.rotation
    w, x, y, z = rotation.w, rotation.x, rotation.y, rotation.z
    turn: rot.Matrix = (
        2 * (w * w + x * x) - 1,
        2 * (x * y - w * z),
        2 * (x * z + w * y),
        2 * (x * y + w * z),
        2 * (w * w + y * y) - 1,
        2 * (y * z - w * x),
        2 * (x * z - w * y),
        2 * (y * z + w * x),
        2 * (w * w + z * z) - 1,
    )
    back = rot.transpose(turn)
    covariance = PoseWithCovariance().covariance
    for top in (0, 18):
        for left in (0, 3):
            indices = [top + left + 6 * row + column for row in range(3) for column in range(3)]
            block = [float(cov_in[index]) for index in indices]
            turned = rot.matrix_product(rot.matrix_product(turn, _nine(block)), back)
            for index, value in zip(indices, turned, strict=True):
                covariance[index] = value
    return covariance


def _nine(values: list[float]) -> rot.Matrix:
    a, b, c, d, e, f, g, h, i = values
    return (a, b, c, d, e, f, g, h, i)


def do_transform_point(point: PointStamped, transform: TransformStamped) -> PointStamped:
    """Return a point in the target frame of `transform`."""
    result = PointStamped()
    result.point.x, result.point.y, result.point.z = _moved(transform, point.point.x, point.point.y, point.point.z)
    result.header = transform.header
    return result


def do_transform_vector3(vector3: Vector3Stamped, transform: TransformStamped) -> Vector3Stamped:
    """Return a vector in the target frame (only rotated). As in the real one, `transform` loses its translation."""
    offset = transform.transform.translation
    offset.x = offset.y = offset.z = 0.0
    vector = vector3.vector
    result = Vector3Stamped()
    result.vector.x, result.vector.y, result.vector.z = _moved(transform, vector.x, vector.y, vector.z)
    result.header = transform.header
    return result


def do_transform_pose(pose: Pose, transform: TransformStamped) -> Pose:
    """Return a pose in the target frame; its orientation has length 1 and w >= 0."""
    result = Pose()
    position = pose.position
    result.position.x, result.position.y, result.position.z = _moved(transform, position.x, position.y, position.z)
    turn = rot.normalized(rot.multiply(_turn(transform.transform.rotation), _turn(pose.orientation)))
    if turn[3] < 0.0:
        turn = (-turn[0], -turn[1], -turn[2], -turn[3])
    orientation = result.orientation
    orientation.x, orientation.y, orientation.z, orientation.w = turn
    return result


def do_transform_pose_stamped(pose: PoseStamped, transform: TransformStamped) -> PoseStamped:
    """Return a stamped pose in the target frame."""
    return PoseStamped(header=transform.header, pose=do_transform_pose(pose.pose, transform))


def do_transform_pose_with_covariance_stamped(
    pose: PoseWithCovarianceStamped, transform: TransformStamped
) -> PoseWithCovarianceStamped:
    """Return a stamped pose with its covariance in the target frame."""
    result = PoseWithCovarianceStamped()
    result.pose.pose = do_transform_pose(pose.pose.pose, transform)
    result.pose.covariance = transform_covariance(pose.pose.covariance, transform)
    result.header = transform.header
    return result


def do_transform_polygon_stamped(polygon: PolygonStamped, transform: TransformStamped) -> PolygonStamped:
    """Return a polygon in the target frame."""
    result = PolygonStamped()
    for point in polygon.polygon.points:
        x, y, z = _moved(transform, point.x, point.y, point.z)
        result.polygon.points.append(Point32(x=x, y=y, z=z))
    result.header = transform.header
    return result


for _type, _function in {
    PointStamped: do_transform_point,
    Vector3Stamped: do_transform_vector3,
    PoseStamped: do_transform_pose_stamped,
    PoseWithCovarianceStamped: do_transform_pose_with_covariance_stamped,
    PolygonStamped: do_transform_polygon_stamped,
}.items():
    TransformRegistration().add(_type, _function)
