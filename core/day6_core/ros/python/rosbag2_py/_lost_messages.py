"""Messages that a recorder lost on their way to it: told on a topic while it records, and at its end (since Lyrical)."""

from __future__ import annotations

import math
import time
from collections import Counter
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value

if TYPE_CHECKING:
    from rclpy.event_handler import QoSMessageLostInfo
    from rclpy.node import Node

TOPIC = "events/rosbag2_messages_lost"


class LostMessages:
    """Counts them by topic. Our recorder itself loses none: what it can't write ends it."""

    def __init__(self, node: Node, rate: float) -> None:
        """`rate`: how often in a second they are told at most; 0: never."""
        self._node = node
        self._rate = rate
        self._publisher: Any = None
        self._untold: Counter[str] = Counter()
        self._total = 0
        self._told = -math.inf

    def offer(self) -> None:
        """Create the topic."""
        if value("bag.recorder_starts_again"):
            from rosbag2_interfaces.msg import MessagesLostEvent

            self._publisher = self._node.create_publisher(MessagesLostEvent, TOPIC, 1)

    def events_of(self, topic: str) -> dict[str, Any]:
        """Return what a subscription is made with, so that its lost messages are counted."""
        if self._publisher is None:
            return {}
        from rclpy.event_handler import SubscriptionEventCallbacks

        def count(info: QoSMessageLostInfo) -> None:
            self._untold[topic] += info.total_count_change
            self._total += info.total_count_change

        return {"event_callbacks": SubscriptionEventCallbacks(message_lost=count, use_default_callbacks=False)}

    def tell(self) -> None:
        """Publish what was lost since the last time, not too often."""
        if not self._untold or self._rate <= 0 or time.monotonic() - self._told < 1 / self._rate:
            return
        from rosbag2_interfaces.msg import MessagesLostEvent, MessagesLostEventTopicStat

        self._told = time.monotonic()
        self._publisher.publish(
            MessagesLostEvent(
                node_name=self._node.get_fully_qualified_name(),
                messages_lost_statistics=[
                    MessagesLostEventTopicStat(topic_name=topic, messages_lost_in_transport=count)
                    for topic, count in sorted(self._untold.items())
                ],
            )
        )
        self._untold.clear()

    def report(self) -> str:
        """Return what is to be warned of at the end of a recording, and begin again; '' if nothing was lost."""
        total, self._total = self._total, 0
        self._untold.clear()
        return f"Number of messages lost on the transport layer: {total}" if total else ""
