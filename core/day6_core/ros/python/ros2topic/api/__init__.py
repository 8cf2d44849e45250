"""Topics, asked of a node or of `ros2cli.node.strategy.NodeStrategy`."""

from __future__ import annotations

import os
import time
from typing import Any

from ros2cli.node.strategy import NodeStrategy
from ros2cli.qos import add_qos_arguments as add_qos_arguments
from ros2cli.qos import profile_configure_short_keys as profile_configure_short_keys
from ros2cli.qos import qos_profile_from_short_keys as qos_profile_from_short_keys
from rosidl_runtime_py import get_message_interfaces, message_to_yaml
from rosidl_runtime_py.utilities import get_message

import rclpy
from day6_core.ros.ros2.cli.message_class import class_of_topic, unpublished
from day6_core.ros.ros2.cli.node import topics
from day6_core.ros.ros2.cli.options import nonnegative_int as nonnegative_int
from day6_core.ros.ros2.cli.options import positive_float as positive_float
from day6_core.ros.ros2.cli.options import positive_int as positive_int
from day6_core.ros.ros2.cli.options import unsigned_int as unsigned_int


def get_topic_names_and_types(*, node: Any, include_hidden_topics: bool = False) -> list[tuple[str, list[str]]]:
    """Return all topics with their types."""
    return [(name, types) for name, types in topics(node, hidden=include_hidden_topics)]


def get_topic_names(*, node: Any, include_hidden_topics: bool = False) -> list[str]:
    """Return the names of all topics."""
    return [name for name, _ in topics(node, hidden=include_hidden_topics)]


def get_msg_class(node: Any, topic: str, blocking: bool = False, include_hidden_topics: bool = False) -> Any:
    """Return the message class of a topic. Without the topic it warns and returns None, or with `blocking` waits for it."""
    found = class_of_topic(node, topic, os.environ)
    if found is None:
        print(unpublished(topic))
    while found is None and blocking and rclpy.ok():
        time.sleep(0.1)
        found = class_of_topic(node, topic, os.environ)
    return found


def message_type_completer(**kwargs: Any) -> list[str]:
    """Complete the type of a message."""
    return [
        f"{package}/{name}" for package, names in sorted(get_message_interfaces().items()) for name in sorted(names)
    ]


class TopicNameCompleter:
    """Completes the name of a topic."""

    def __init__(self, *, include_hidden_topics_key: str | None = None) -> None:
        self.include_hidden_topics_key = include_hidden_topics_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        hidden = bool(getattr(parsed_args, self.include_hidden_topics_key or "", False))
        with NodeStrategy(parsed_args) as node:
            return get_topic_names(node=node, include_hidden_topics=hidden)


class TopicTypeCompleter:
    """Completes the type of a topic: of the one that was named, else every type."""

    def __init__(self, *, topic_name_key: str | None = None) -> None:
        self.topic_name_key = topic_name_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        found: list[str] = []
        if self.topic_name_key is not None:
            with NodeStrategy(parsed_args) as node:
                found = dict(get_topic_names_and_types(node=node, include_hidden_topics=True)).get(
                    getattr(parsed_args, self.topic_name_key), []
                )
        return found or message_type_completer()


class TopicMessagePrototypeCompleter:
    """Completes a message with its default values."""

    def __init__(self, *, topic_type_key: str | None = None) -> None:
        self.topic_type_key = topic_type_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        return [message_to_yaml(get_message(getattr(parsed_args, self.topic_type_key or ""))())]
