"""dummy_joint_states: both joints of the RRBot swing between -1 and 1 radian (dummy_sensors/src/dummy_joint_states.cpp)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from sensor_msgs.msg import JointState

from day6_core.ros.programs._component import spin_cpp
from day6_core.ros.programs.rclcpp import create_node

if TYPE_CHECKING:
    from day6_core.session.session import Session

JOINTS = ["single_rrbot_joint1", "single_rrbot_joint2"]
HERTZ = 50.0
STEP = 0.1
"""Radians of the sine's argument from one message to the next."""


async def main(session: Session) -> int:
    node = create_node(session, "dummy_joint_states")
    publisher = node.create_publisher(JointState, "joint_states", 10)
    argument = 0.0

    def publish() -> None:
        nonlocal argument
        argument += STEP
        message = JointState(name=JOINTS, position=[math.sin(argument)] * len(JOINTS))
        message.header.stamp = node.get_clock().now().to_msg()
        publisher.publish(message)

    node.create_timer(1 / HERTZ, publish)
    return await spin_cpp(session, node)
