"""Stands between a publisher and a subscriber, and changes what goes through."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.node import Node


class DataRepublisher:
    """Publishes on one topic what `transform_fn` makes of each message of another one; None drops the message."""

    def __init__(
        self,
        node: Node,
        listen_topic: str,
        publish_topic: str,
        msg_type: type[Any],
        transform_fn: Callable[[Any], Any],
    ) -> None:
        self.__node = node
        self.__transform = transform_fn
        self.__received = 0
        self.__republished: list[Any] = []
        self.__subscription = node.create_subscription(msg_type, listen_topic, self.__pass_on, 10)
        self.__publisher = node.create_publisher(msg_type, publish_topic, 10)

    def shutdown(self) -> None:
        """Destroy both endpoints."""
        self.__node.destroy_subscription(self.__subscription)
        self.__node.destroy_publisher(self.__publisher)

    def get_num_received(self) -> int:
        return self.__received

    def get_num_republished(self) -> int:
        return len(self.__republished)

    def get_republished(self) -> list[Any]:
        """Return the messages that were passed on, as they were received."""
        return self.__republished

    def __pass_on(self, message: Any) -> None:
        self.__received += 1
        changed = self.__transform(message)
        if changed:
            self.__republished.append(message)
            self.__publisher.publish(changed)
