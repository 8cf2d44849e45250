"""Transforms point clouds."""

from __future__ import annotations

from typing import Any

import numpy as np
from geometry_msgs.msg import Transform, TransformStamped
from sensor_msgs.msg import PointCloud2
from sensor_msgs_py.numpy_compat import structured_to_unstructured, unstructured_to_structured
from sensor_msgs_py.point_cloud2 import create_cloud, read_points
from std_msgs.msg import Header
from tf2_ros.buffer_interface import ConvertRegistration, TransformRegistration


def to_msg_msg(msg: Any) -> Any:
    """Return the message itself: it needs no conversion."""
    return msg


def from_msg_msg(msg: Any) -> Any:
    """Return the message itself: it needs no conversion."""
    return msg


def transform_points(point_cloud: np.ndarray[Any, Any], transform: Transform) -> np.ndarray[Any, Any]:
    """Return points, shape (N, 3), rotated and translated by a transform."""
    offset, turn = transform.translation, transform.rotation
    turned = point_cloud @ _matrix(turn.w, turn.x, turn.y, turn.z).T
    moved: np.ndarray[Any, Any] = turned + np.array([offset.x, offset.y, offset.z])
    return moved


def do_transform_cloud(cloud: PointCloud2, transform: Transform | TransformStamped) -> PointCloud2:
    """Return the cloud with x, y and z transformed; with a TransformStamped it gets that frame.

    Raises AssertionError for a cloud without these fields.
    """
    header = Header(stamp=cloud.header.stamp, frame_id=cloud.header.frame_id)
    if isinstance(transform, TransformStamped):
        header.frame_id = transform.header.frame_id
        transform = transform.transform
    names = {field.name for field in cloud.fields}
    assert names >= set("xyz"), "Point cloud needs the fields x, y, and z for the transformation"
    points = read_points(cloud)
    moved = transform_points(structured_to_unstructured(points[["x", "y", "z"]]), transform)
    if names == set("xyz"):
        return create_cloud(header, cloud.fields, moved)
    points = points.copy()
    points[["x", "y", "z"]] = unstructured_to_structured(moved, names=("x", "y", "z"))
    return create_cloud(header, cloud.fields, points)


def _matrix(w: float, x: float, y: float, z: float) -> np.ndarray[Any, Any]:
    """Return the matrix of a rotation; a quaternion of length 0 counts as the identity."""
    size = w * w + x * x + y * y + z * z
    if size < np.finfo(np.float64).eps:
        return np.eye(3)
    vector = np.array([x, y, z])
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    turned: np.ndarray[Any, Any] = np.eye(3) + 2 / size * (
        w * cross + np.outer(vector, vector) - (vector @ vector) * np.eye(3)
    )
    return turned


ConvertRegistration().add_to_msg(PointCloud2, to_msg_msg)
ConvertRegistration().add_from_msg(PointCloud2, from_msg_msg)
TransformRegistration().add(PointCloud2, do_transform_cloud)
