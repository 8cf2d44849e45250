"""wheel_spinner: publishes on /joint_states, 50 times a second, that the car's wheels have turned a little further."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from sensor_msgs.msg import JointState

from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

PERIOD = 0.02
"""Seconds between two messages: 50 Hz, smooth for the eye."""

STEP = 0.02
"""Radians from one message to the next: 1 rad/s, fast enough to see and slow enough to follow."""

JOINTS = ["left_wheel_joint", "right_wheel_joint"]
"""The names must be those of the URDF, letter for letter."""


class WheelSpinner:
    """Parameters: `joints` (names), `step` (radians a message; negative rolls backwards)."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._joints = list(node.declare_parameter("joints", JOINTS).value)
        step = node.declare_parameter("step", STEP).value
        self._publisher = node.create_publisher(JointState, "joint_states", QoSProfile(depth=10))
        self.angle = 0.0
        self._gone = 0.0
        node.create_timer(PERIOD, self._turn_a_little)
        node.get_logger().info(f"Turning {', '.join(self._joints)} by {step} rad every {PERIOD} s")

    def _turn_a_little(self) -> None:
        step = self._node.get_parameter("step").value
        self.angle = (self.angle + step) % (2 * math.pi)
        state = JointState()
        state.header.stamp = self._node.get_clock().now().to_msg()
        state.name = self._joints
        state.position = [self.angle] * len(self._joints)
        self._publisher.publish(state)
        turns = int(self._gone / (2 * math.pi))
        self._gone += abs(step)
        if int(self._gone / (2 * math.pi)) > turns:
            self._node.get_logger().info(f"Turn {turns + 1} finished")


async def main(session: Session) -> int:
    node = session.create_node("wheel_spinner")
    WheelSpinner(node)
    await session.spin(node)
    return 0
