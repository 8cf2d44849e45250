"""The message class of a topic, found from its name."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from day6_core.ros.environment import shipped_packages
from rclpy.exceptions import InvalidTopicNameException
from rclpy.expand_topic_name import expand_topic_name
from rclpy.validate_full_topic_name import validate_full_topic_name

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

POLL_SECONDS = 0.1


def message_class(type_name: str, environment: Mapping[str, str]) -> Any:
    """Return the class of a message type that the user named. Raises RuntimeError if this terminal knows none."""
    try:
        return _class_of(type_name, environment)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError("The passed message type is invalid") from None


def class_of_topic(node: Node, topic: str, environment: Mapping[str, str]) -> Any | None:
    """Return the message class of a topic, None if it doesn't exist. Raises RuntimeError for several types or an unknown one."""
    try:
        full_name = expand_topic_name(topic, node.get_name(), node.get_namespace())
        validate_full_topic_name(full_name)
    except (ValueError, InvalidTopicNameException) as error:
        raise RuntimeError(error) from None
    types = dict(node.get_topic_names_and_types()).get(full_name)
    if types is None:
        return None
    if len(types) > 1:
        raise RuntimeError(f"Cannot echo topic '{topic}', as it contains more than one type: [{', '.join(types)}]")
    try:
        return _class_of(types[0], environment)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(f"The message type '{types[0]}' is invalid") from None


def _class_of(type_name: str, environment: Mapping[str, str]) -> Any:
    """The class; one of a workspace only where the terminal has sourced it, though another terminal of this process may have."""
    from rosidl_runtime_py.utilities import get_message

    package = type_name.partition("/")[0]
    paths = (variables.get("AMENT_PREFIX_PATH", "") for variables in (environment, os.environ))
    prefixes = [prefix for path in paths for prefix in path.split(os.pathsep) if prefix]
    found = any(os.path.isdir(os.path.join(prefix, "share", package)) for prefix in prefixes)
    if not found and package not in shipped_packages():
        raise ModuleNotFoundError(package)
    return get_message(type_name)


def unpublished(topic: str) -> str:
    """Return the warning for a topic without a publisher."""
    return f"WARNING: topic [{topic}] does not appear to be published yet"


async def wait_for_class(session: Session, node: Node, topic: str) -> Any:
    """Return the message class of a topic; if it doesn't exist yet, warn and wait until it does."""
    found = class_of_topic(node, topic, session.env)
    if found is None:
        session.print(unpublished(topic))
    while found is None:
        await session.sleep(POLL_SECONDS)
        found = class_of_topic(node, topic, session.env)
    return found
