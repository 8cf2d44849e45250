"""talker_loaned_message: two topics, one with a plain number and one with a text."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import run
from day6_core.ros.programs.demo_messages import Float64, String
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class LoanedMessageTalker:
    """In real ROS it borrows the memory of its messages from the middleware; subscribers see no difference."""

    NAME = "loaned_message_talker"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        self._numbers = node.create_publisher(Float64, "chatter_pod", QoSProfile(depth=7))
        self._texts = node.create_publisher(String, "chatter", QoSProfile(depth=7))
        self._count = 0
        node.create_timer(1.0, self._publish)

    def _publish(self) -> None:
        self._count += 1
        number, text = Float64(data=float(self._count)), String(data=f"Hello World: {self._count}")
        self._logger.info(f"Publishing: '{number.data:f}'")
        self._numbers.publish(number)
        self._logger.info(f"Publishing: '{text.data}'")
        self._texts.publish(text)


async def main(session: Session) -> int:
    return await run(session, LoanedMessageTalker)
