"""talker: publishes Hello World once a second."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.demo_messages import String

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class Talker:
    """Publishes on `chatter`; counts from 0, the C++ version from 1."""

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        self._publisher = node.create_publisher(String, "chatter", 10)
        self._count = 0
        node.create_timer(1.0, self._publish)

    def _publish(self) -> None:
        message = String(data=f"Hello World: {self._count}")
        self._count += 1
        self._logger.info(f'Publishing: "{message.data}"')
        self._publisher.publish(message)


async def main(session: Session) -> int:
    node = session.create_node("talker")
    Talker(node)
    return await spin(session, node)
