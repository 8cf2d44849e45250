"""talker: publishes Hello World once a second."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import run
from day6_core.ros.programs.demo_messages import String
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class Talker:
    """Publishes on `chatter`; counts from 1, the Python version from 0."""

    NAME = "talker"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        self._publisher = node.create_publisher(String, "chatter", QoSProfile(depth=7))
        self._count = 0
        node.create_timer(1.0, self._publish)

    def _publish(self) -> None:
        self._count += 1
        message = String(data=f"Hello World: {self._count}")
        self._logger.info(f"Publishing: '{message.data}'")
        self._publisher.publish(message)


async def main(session: Session) -> int:
    return await run(session, Talker)
