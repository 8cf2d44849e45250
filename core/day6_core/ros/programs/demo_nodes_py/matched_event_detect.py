"""matched_event_detect: a node hears when others subscribe to its topic, or publish what it subscribes to."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.demo_messages import String
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.task import Future

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

PUBLISHED, SUBSCRIBED = "pub_topic_matched_event_detect", "sub_topic_matched_event_detect"
LONGEST = 10.0


async def main(session: Session) -> int:
    return await detect(session, "matched_event_detection_node", "")


async def detect(session: Session, name: str, end: str) -> int:
    """Let two subscriptions and two publishers come and go; `end` closes the longer sentences (C++ has a full stop)."""
    node = session.create_node(name)
    heard: list[Future[bool]] = [Future()]

    def follow(others: str) -> Any:
        any_there = False

        def changed(info: Any) -> None:
            nonlocal any_there
            count = int(info.current_count)
            if any_there and count == 0:
                node.get_logger().info(f"Last {others} is disconnected.")
            elif any_there:
                node.get_logger().info(
                    f"The changed number of connected {others} is {info.current_count_change} and "
                    f"current number of connected {others} is {count}{end}"
                )
            elif count:
                node.get_logger().info(f"First {others} is connected.")
            any_there = count > 0
            heard[0].set_result(True)

        return changed

    node.create_publisher(
        String, PUBLISHED, 10, event_callbacks=PublisherEventCallbacks(matched=follow("subscription"))
    )
    node.create_subscription(
        String, SUBSCRIBED, _ignore, 10, event_callbacks=SubscriptionEventCallbacks(matched=follow("publisher"))
    )
    subscribers, publishers = session.create_node("multi_sub_node"), session.create_node("multi_pub_node")
    for each in (node, subscribers, publishers):
        session.executor.add_node(each)

    async def settle() -> None:
        await session.spin_until(heard[0], LONGEST)
        heard[0] = Future()

    try:
        await _come_and_go(subscribers, "subscription", settle)
        await _come_and_go(publishers, "publisher", settle)
    except KeyboardInterrupt:
        return 0
    return 0


async def _come_and_go(node: Node, what: str, settle: Any) -> None:
    made: list[Any] = []
    for _ in range(2):
        node.get_logger().info(f"Create a new {what}.")
        if what == "subscription":
            made.append(node.create_subscription(String, PUBLISHED, _ignore, 10))
        else:
            made.append(node.create_publisher(String, SUBSCRIBED, 10))
        await settle()
    for each in made:
        node.get_logger().info(f"Destroy a {what}.")
        if what == "subscription":
            node.destroy_subscription(each)
        else:
            node.destroy_publisher(each)
        await settle()


def _ignore(_: String) -> None:
    """Only that they are connected matters."""
