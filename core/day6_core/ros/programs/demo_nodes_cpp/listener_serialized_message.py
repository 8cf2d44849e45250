"""listener_serialized_message: shows the bytes of what comes on `chatter`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_messages import String
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from rclpy.serialization import deserialize_message

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = create_node(session, "serialized_message_listener")

    def hear(data: bytes) -> None:
        session.print(f"I heard data of length: {len(data)}")
        session.print(data.hex(" "), "")
        session.print(f"serialized data after deserialization: {deserialize_message(data, String).data}")

    node.create_subscription(String, "chatter", hear, 10, raw=True)
    try:
        await session.spin(node)
    except STOPPED:
        log_interrupt(session)
    return 0
