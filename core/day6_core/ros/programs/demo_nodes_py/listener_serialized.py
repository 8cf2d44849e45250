"""listener_serialized: shows the bytes of what comes on `chatter`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.demo_messages import String

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("serialized_subscriber")
    node.create_subscription(String, "chatter", lambda data: node.get_logger().info(f'I heard: "{data}"'), 10, raw=True)
    return await spin(session, node)
