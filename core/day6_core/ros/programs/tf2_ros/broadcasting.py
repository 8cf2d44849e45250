"""The broadcasters of tf2_ros for C++ nodes: parameters can change the QoS of their publishers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage

from day6_core.ros.programs.rclcpp.qos import DYNAMIC_TF, STATIC_TF
from rclpy.qos import DurabilityPolicy, QoSProfile

if TYPE_CHECKING:
    from rclpy.node import Node


class TransformBroadcaster:
    """Publishes the transforms of moving frames on /tf (tf2_ros/transform_broadcaster.h)."""

    def __init__(self, node: Node) -> None:
        self._publisher: Any = node.create_publisher(
            TFMessage, "/tf", QoSProfile(depth=100), qos_overriding_options=DYNAMIC_TF
        )

    def sendTransform(self, transform: TransformStamped) -> None:
        self._publisher.publish(TFMessage(transforms=[transform]))


class StaticTransformBroadcaster:
    """Publishes transforms on /tf_static, all frames each time; a later one of a frame replaces it, other than in Python."""

    def __init__(self, node: Node) -> None:
        qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._publisher: Any = node.create_publisher(TFMessage, "/tf_static", qos, qos_overriding_options=STATIC_TF)
        self._transforms: dict[str, TransformStamped] = {}

    def sendTransform(self, transform: TransformStamped) -> None:
        self._transforms[transform.child_frame_id] = transform
        self._publisher.publish(TFMessage(transforms=list(self._transforms.values())))
