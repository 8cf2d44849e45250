"""Nodes and what they have, asked of a node or of `ros2cli.node.strategy.NodeStrategy`."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from ros2cli.node.strategy import NodeStrategy

from day6_core.graph.names import is_hidden
from day6_core.ros.ros2.cli.node import HIDDEN_PREFIX, absolute, split_name
from day6_core.ros.ros2.node.info import SEVERAL

INFO_NONUNIQUE_WARNING_TEMPLATE = SEVERAL


class NodeName(NamedTuple):
    """A node's name, in its parts and whole."""

    name: str
    namespace: str
    full_name: str


class TopicInfo(NamedTuple):
    """The name of a topic, service or action and its types."""

    name: str
    types: list[str]


def get_absolute_node_name(node_name: str) -> str | None:
    """Return the name with its leading slash; None for no name."""
    return absolute(node_name) if node_name else None


def parse_node_name(node_name: str) -> NodeName:
    """Return the parts of a full name, whose leading slash may be missing."""
    return NodeName(*split_name(node_name), absolute(node_name))


def has_duplicates(values: Sequence[Any]) -> bool:
    """Return whether a value is there twice."""
    return len(set(values)) < len(values)


def get_node_names(*, node: Any, include_hidden_nodes: bool = False) -> list[NodeName]:
    """Return all nodes; a name that two have is there twice."""
    return [
        NodeName(name, namespace, f"{namespace.rstrip('/')}/{name}")
        for name, namespace in node.get_node_names_and_namespaces()
        if include_hidden_nodes or not name.startswith(HIDDEN_PREFIX)
    ]


def wait_for_node(node: Any, node_name: str, include_hidden_nodes: bool = False, timeout: float = 1.0) -> bool:
    """Return whether a node is there within `timeout` seconds; a negative number waits for ever."""
    deadline = time.monotonic() + timeout
    while not any(
        each.full_name == node_name for each in get_node_names(node=node, include_hidden_nodes=include_hidden_nodes)
    ):
        if timeout >= 0 and time.monotonic() > deadline:
            return False
        time.sleep(0.1)
    return True


def get_topics(
    remote_node_name: str, func: Callable[[str, str], Any], *, include_hidden_topics: bool = False
) -> list[TopicInfo]:
    """Return what `func(name, namespace)` says of a node."""
    name = parse_node_name(remote_node_name)
    return [
        TopicInfo(found, types)
        for found, types in func(name.name, name.namespace)
        if include_hidden_topics or not is_hidden(found)
    ]


def _info(method: str, what: str) -> Callable[..., list[TopicInfo]]:
    def info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
        return get_topics(remote_node_name, getattr(node, method), include_hidden_topics=include_hidden)

    info.__doc__ = f"Return the {what} of a node."
    return info


get_subscriber_info = _info("get_subscriber_names_and_types_by_node", "subscriptions")
get_publisher_info = _info("get_publisher_names_and_types_by_node", "publishers")
get_service_client_info = _info("get_client_names_and_types_by_node", "service clients")
get_service_server_info = _info("get_service_names_and_types_by_node", "services")
get_action_server_info = _info("get_action_server_names_and_types_by_node", "action servers")
get_action_client_info = _info("get_action_client_names_and_types_by_node", "action clients")


class NodeNameCompleter:
    """Completes the name of a node."""

    def __init__(self, *, include_hidden_nodes_key: str | None = None) -> None:
        self.include_hidden_nodes_key = include_hidden_nodes_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        hidden = bool(getattr(parsed_args, self.include_hidden_nodes_key or "", False))
        with NodeStrategy(parsed_args) as node:
            return [each.full_name for each in get_node_names(node=node, include_hidden_nodes=hidden)]
