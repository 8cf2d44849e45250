"""Waits until there are messages on topics."""

from __future__ import annotations

import random
import string
from collections import deque
from collections.abc import Callable, Iterable
from contextlib import suppress
from threading import Event, Thread
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor


class WaitForTopics:
    """Waits for a message on each of some topics: as a context manager, or by `wait` and `shutdown`.

    `topic_tuples` are pairs of a topic and its message class, `timeout` is in seconds. Of each topic the last messages are kept,
    10 unless `messages_received_buffer_length` says otherwise. Entering raises RuntimeError when the time is over.
    """

    def __init__(
        self,
        topic_tuples: Iterable[tuple[str, type[Any]]],
        timeout: float = 5.0,
        messages_received_buffer_length: int = 10,
    ) -> None:
        self.topic_tuples = list(topic_tuples)
        self.timeout = timeout
        self.messages_received_buffer_length = messages_received_buffer_length
        self.__all_received = Event()
        self.__messages: dict[str, deque[Any]] = {}
        self.__context = rclpy.Context()
        rclpy.init(context=self.__context)
        name = "_test_node_" + "".join(random.choices(string.ascii_uppercase + string.digits, k=10))
        self.__node = rclpy.create_node(name, context=self.__context)
        self.__executor = SingleThreadedExecutor(context=self.__context)
        self.__executor.add_node(self.__node)
        self.__thread = Thread(target=self.__spin, name="wait_for_topics")
        self.__thread.start()

    def wait(self) -> bool:
        """Wait; returns whether all topics had a message, counted from this call."""
        self.__all_received.clear()
        for kept in self.__messages.values():
            kept.clear()
        new = [pair for pair in self.topic_tuples if pair[0] not in self.__messages]
        self.__messages.update((topic, deque(maxlen=self.messages_received_buffer_length)) for topic, _ in new)
        for topic, message_class in new:
            self.__node.create_subscription(message_class, topic, self.__keeper_of(topic), 10)
        return self.__all_received.wait(self.timeout)

    def shutdown(self) -> None:
        """End the thread and destroy the node."""
        self.__context.try_shutdown()
        self.__thread.join()
        self.__node.destroy_node()

    def topics_received(self) -> set[str]:
        return {topic for topic, kept in self.__messages.items() if kept}

    def topics_not_received(self) -> set[str]:
        return set(self.__messages) - self.topics_received()

    def received_messages(self, topic_name: str) -> list[Any]:
        """Return the last messages of a topic. Raises KeyError for a topic that is not waited for."""
        if topic_name not in self.__messages:
            raise KeyError(f"No messages received for topic: {topic_name}")
        return list(self.__messages[topic_name])

    def __enter__(self) -> WaitForTopics:
        if not self.wait():
            raise RuntimeError("Did not receive messages on these topics: ", self.topics_not_received())
        return self

    def __exit__(self, *_: object) -> None:
        self.shutdown()

    def __spin(self) -> None:
        with suppress(ExternalShutdownException):
            self.__executor.spin()

    def __keeper_of(self, topic: str) -> Callable[[Any], None]:
        def keep(message: Any) -> None:
            self.__messages[topic].append(message)
            if not self.topics_not_received():
                self.__all_received.set()

        return keep
