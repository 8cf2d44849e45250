"""subscriber_member_function: logs what comes on `topic`, in the original written with a class that is a node."""

from __future__ import annotations

from typing import TYPE_CHECKING

from std_msgs.msg import String

from day6_core.ros.programs._waiting import spin

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("minimal_subscriber")
    node.create_subscription(String, "topic", lambda each: node.get_logger().info(f'I heard: "{each.data}"'), 10)
    return await spin(session, node)
