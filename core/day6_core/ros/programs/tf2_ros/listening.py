"""What the C++ tools of tf2_ros have in common: a listener with a node of its own, and C++'s way to print numbers."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

from tf2_msgs.msg import TFMessage
from tf2_ros import Buffer

from day6_core.ros.programs.rclcpp import create_node
from day6_core.ros.programs.rclcpp.qos import DYNAMIC_TF, STATIC_TF
from rclpy.qos import DurabilityPolicy, QoSProfile

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

_AUTHORITY = "Authority undetectable"


def listen(session: Session, buffer: Buffer) -> Node:
    """Fill `buffer` from a new node like tf2_ros::TransformListener's, which the caller has to spin."""
    name = f"transform_listener_impl_{random.randrange(0x5500_0000_0000, 0x5700_0000_0000, 16):x}"
    # Its name stays, whatever __node the command line asks for.
    arguments = ["--ros-args", "-r", f"__node:={name}"]
    node = create_node(
        session, name, cli_args=arguments, start_parameter_services=False, start_parameter_event_publisher=False
    )

    def take(message: TFMessage) -> None:
        for transform in message.transforms:
            buffer.set_transform(transform, _AUTHORITY)

    def take_static(message: TFMessage) -> None:
        for transform in message.transforms:
            buffer.set_transform_static(transform, _AUTHORITY)

    latched = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(TFMessage, "/tf", take, QoSProfile(depth=100), qos_overriding_options=DYNAMIC_TF)
    node.create_subscription(TFMessage, "/tf_static", take_static, latched, qos_overriding_options=STATIC_TF)
    return node


def log_without_node(session: Session, level: str, text: str) -> None:
    """Log as RCUTILS_LOG_WARN and the like do, which know no logger's name."""
    seconds, nanoseconds = divmod(session.clock.now_ns(), 1_000_000_000)
    session.print_error(f"[{level}] [{seconds}.{nanoseconds:09d}] []: {text}")
