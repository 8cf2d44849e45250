"""talker_serialized_message: a talker that makes the bytes of its messages itself, and shows them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_messages import String
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from rclpy.qos import QoSProfile
from rclpy.serialization import serialize_message

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = create_node(session, "serialized_message_talker")
    publisher = node.create_publisher(String, "chatter", QoSProfile(depth=7))
    count = 0

    def publish() -> None:
        nonlocal count
        count += 1
        message = String(data=f"Hello World:{count}")
        data = serialize_message(message)
        session.print(f"ROS message:\n{message.data}\nserialized message:")
        session.print(data.hex(" "), "")
        publisher.publish(data)

    node.create_timer(1.0, publish)
    try:
        await session.spin(node)
    except STOPPED:
        log_interrupt(session)
    return 0
