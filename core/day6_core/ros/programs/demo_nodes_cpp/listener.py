"""listener: logs what comes on `chatter`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import run
from day6_core.ros.programs.demo_messages import String

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class Listener:
    """Subscribes to `chatter`."""

    NAME = "listener"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        node.create_subscription(String, "chatter", self._hear, 10)

    def _hear(self, message: String) -> None:
        self._logger.info(f"I heard: [{message.data}]")


async def main(session: Session) -> int:
    return await run(session, Listener)
