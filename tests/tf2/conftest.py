"""Transforms, and a second way to reckon with them: 4x4 matrices, which share no code with the buffer."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
import pytest
from geometry_msgs.msg import TransformStamped
from numpy.typing import NDArray

import rclpy
from rclpy.node import Node

Array = NDArray[np.float64]


def stamped(
    parent: str,
    child: str,
    seconds: float = 0.0,
    translation: Sequence[float] = (0.0, 0.0, 0.0),
    rotation: Sequence[float] = (0.0, 0.0, 0.0, 1.0),
) -> TransformStamped:
    """A transform message; `rotation` is x, y, z, w."""
    message = TransformStamped()
    message.header.frame_id = parent
    message.child_frame_id = child
    message.header.stamp.sec, message.header.stamp.nanosec = divmod(round(seconds * 1e9), 1_000_000_000)
    offset, turn = message.transform.translation, message.transform.rotation
    offset.x, offset.y, offset.z = map(float, translation)
    turn.x, turn.y, turn.z, turn.w = map(float, rotation)
    return message


def matrix_of(translation: Sequence[float], rotation: Sequence[float]) -> Array:
    """The 4x4 matrix, by Rodrigues' formula from axis and angle."""
    x, y, z, w = np.asarray(rotation, dtype=float) / np.linalg.norm(rotation)
    sine = math.sqrt(x * x + y * y + z * z)
    angle = 2.0 * math.atan2(sine, w)
    axis = np.array([x, y, z]) / sine if sine else np.zeros(3)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    matrix = np.eye(4)
    matrix[:3, :3] = np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * (k @ k)
    matrix[:3, 3] = translation
    return matrix


def matrix_of_message(message: TransformStamped) -> Array:
    offset, turn = message.transform.translation, message.transform.rotation
    return matrix_of((offset.x, offset.y, offset.z), (turn.x, turn.y, turn.z, turn.w))


@pytest.fixture
def ros() -> Iterator[None]:
    rclpy.init()
    yield
    rclpy.try_shutdown()


@pytest.fixture
def node(ros: None) -> Iterator[Node]:
    node = Node("test_node")
    yield node
    node.destroy_node()
