"""tf2_geometry_msgs against matrices."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
import tf2_geometry_msgs
import tf2_ros
from geometry_msgs.msg import (
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    TransformStamped,
    Vector3Stamped,
)
from hypothesis import given, settings
from hypothesis import strategies as st

from rclpy.duration import Duration
from tests.tf2.conftest import matrix_of, matrix_of_message, stamped


def random_transform(chance: random.Random) -> TransformStamped:
    parts = [chance.gauss(0, 1) for _ in range(4)]
    length = math.sqrt(sum(part * part for part in parts))
    offset = [chance.uniform(-5, 5) for _ in range(3)]
    return stamped("world", "car", 1, offset, [part / length for part in parts])


@given(seed=st.integers(0, 10_000))
@settings(max_examples=50, deadline=None)
def test_points_vectors_poses_and_polygons_move_as_matrices_say(seed: int) -> None:
    chance = random.Random(seed)
    transform, other = random_transform(chance), random_transform(chance)
    matrix = matrix_of_message(transform)
    x, y, z = (chance.uniform(-3, 3) for _ in range(3))

    point = PointStamped()
    point.point.x, point.point.y, point.point.z = x, y, z
    moved = tf2_geometry_msgs.do_transform_point(point, transform)
    assert np.allclose([moved.point.x, moved.point.y, moved.point.z], (matrix @ [x, y, z, 1])[:3])
    assert moved.header.frame_id == "world"

    polygon = PolygonStamped()
    polygon.polygon.points = [Point32(x=x, y=y, z=z), Point32()]
    corners = tf2_geometry_msgs.do_transform_polygon_stamped(polygon, transform).polygon.points
    assert np.allclose([corners[0].x, corners[0].y, corners[0].z], (matrix @ [x, y, z, 1])[:3], atol=1e-5)
    assert np.allclose([corners[1].x, corners[1].y, corners[1].z], matrix[:3, 3], atol=1e-5)

    pose = Pose(orientation=other.transform.rotation)
    pose.position.x, pose.position.y, pose.position.z = x, y, z
    turned = tf2_geometry_msgs.do_transform_pose(pose, transform)
    place, turn = turned.position, turned.orientation
    found = matrix_of((place.x, place.y, place.z), (turn.x, turn.y, turn.z, turn.w))
    first = other.transform.rotation
    assert np.allclose(found, matrix @ matrix_of((x, y, z), (first.x, first.y, first.z, first.w)), atol=1e-9)
    assert turn.w >= 0

    vector = Vector3Stamped()
    vector.vector.x, vector.vector.y, vector.vector.z = x, y, z
    direction = tf2_geometry_msgs.do_transform_vector3(vector, transform).vector
    assert np.allclose([direction.x, direction.y, direction.z], matrix[:3, :3] @ [x, y, z])


def test_a_vector_takes_the_translation_out_of_its_transform_as_in_the_real_package() -> None:
    transform = stamped("world", "car", 1, (1, 2, 3))
    tf2_geometry_msgs.do_transform_vector3(Vector3Stamped(), transform)
    assert transform.transform.translation.x == 0.0


def test_a_pose_without_orientation_is_not_turned() -> None:
    pose = Pose()
    pose.orientation.w = 0.0
    transform = stamped("world", "car", 1, (1, 0, 0), (0, 0, math.sqrt(0.5), math.sqrt(0.5)))
    turned = tf2_geometry_msgs.do_transform_pose(pose, transform)
    assert turned.orientation.z == pytest.approx(math.sqrt(0.5))


def test_a_covariance_is_turned_with_its_pose() -> None:
    chance = random.Random(5)
    transform = random_transform(chance)
    pose = PoseWithCovarianceStamped()
    covariance = np.array([chance.uniform(-1, 1) for _ in range(36)])
    pose.pose.covariance = covariance
    moved = tf2_geometry_msgs.do_transform_pose_with_covariance_stamped(pose, transform)
    turn = np.kron(np.eye(2), matrix_of_message(transform)[:3, :3])
    assert np.allclose(moved.pose.covariance, (turn @ covariance.reshape(6, 6) @ turn.T).ravel())
    assert type(moved.pose.covariance) is type(pose.pose.covariance)


def test_a_buffer_transforms_what_is_registered() -> None:
    buffer = tf2_ros.Buffer()
    for second in (1, 3):
        buffer.set_transform(stamped("world", "car", second, (second, 0, 0)), "test")
    pose = PoseStamped()
    pose.header.frame_id = "car"
    pose.header.stamp.sec = 2
    moved = buffer.transform(pose, "world", Duration(seconds=0))
    assert (moved.pose.position.x, moved.header.frame_id, moved.header.stamp.sec) == (2.0, "world", 2)
    later = buffer.transform_full(pose, "car", pose.header.stamp.__class__(sec=3), "world")
    assert later.pose.position.x == -1.0
    assert buffer.transform(pose, "world", new_type=PoseStamped) == moved
