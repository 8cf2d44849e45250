"""A machine whose time the test moves on, with the robot's programs on it and a node that listens."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from sensor_msgs.msg import JointState

from day6_urdf import shipped_model
from tests.support.stepped_machine import Running, SteppedMachine


class Machine(SteppedMachine):
    WHILE_WAITING = 0.0

    def __init__(self) -> None:
        super().__init__()
        self._joints: Any = None

    def publish_robot(self, *args: str) -> Running:
        """Start robot_state_publisher with the shipped car."""
        return self.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()), *args)

    def joint_states(self, names: list[str], positions: list[float], after: float = 0.06, stamp: bool = True) -> None:
        """Publish one message `after` seconds, with the stamp of then or none."""
        self.advance(after)
        message = JointState(name=names, position=positions)
        if stamp:
            message.header.stamp = self.node.get_clock().now().to_msg()
        if self._joints is None:  # only now: a publisher is seen by whoever counts them
            self._joints = self.node.create_publisher(JointState, "joint_states", 10)
        self._joints.publish(message)
        self.advance()

    def watch(self, message: type, topic: str, qos: Any = 100) -> list[Any]:
        return super().watch(message, topic, qos)


@pytest.fixture
def machine() -> Iterator[Machine]:
    machine = Machine()
    yield machine
    machine.end()
