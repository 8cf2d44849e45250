"""All three publishers: seen from outside they differ in their first message only."""

from __future__ import annotations

from typing import TYPE_CHECKING

from std_msgs.msg import String

from day6_core.ros.programs._waiting import spin

if TYPE_CHECKING:
    from day6_core.session.session import Session

PERIOD = 0.5


async def publish(session: Session, *, at_once: bool) -> int:
    """Publish on `topic` until Ctrl-C; `at_once`: the first message comes before the first pause."""
    node = session.create_node("minimal_publisher")
    publisher = node.create_publisher(String, "topic", 10)
    count = 0

    def tick() -> None:
        nonlocal count
        message = String(data=f"Hello World: {count}")
        count += 1
        node.get_logger().info(f'Publishing: "{message.data}"')
        publisher.publish(message)

    if at_once:
        tick()
    node.create_timer(PERIOD, tick)
    return await spin(session, node)
