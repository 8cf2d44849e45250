"""Which actions exist: their servers and clients are recognised by the topics they publish and subscribe."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rclpy.node import Node

NamesAndTypes = list[tuple[str, list[str]]]

_FEEDBACK = "/_action/feedback"
_FEEDBACK_TYPE = "_FeedbackMessage"


def _actions(topics: NamesAndTypes) -> NamesAndTypes:
    """Turn feedback topics into actions: `/fib/_action/feedback` of `…/action/Fibonacci_FeedbackMessage` is `/fib`."""
    return [
        (name[: -len(_FEEDBACK)], [each[: -len(_FEEDBACK_TYPE)] for each in types if each.endswith(_FEEDBACK_TYPE)])
        for name, types in topics
        if name.endswith(_FEEDBACK)
    ]


def get_action_client_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return `(action name, types)` of the action clients of a node; NodeNameNonExistentError if there is none."""
    return _actions(node.get_subscriber_names_and_types_by_node(remote_node_name, remote_node_namespace, True))


def get_action_server_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return `(action name, types)` of the action servers of a node; NodeNameNonExistentError if there is none."""
    return _actions(node.get_publisher_names_and_types_by_node(remote_node_name, remote_node_namespace, True))


def get_action_names_and_types(node: Node) -> NamesAndTypes:
    """Return `(action name, types)` of all actions of the graph."""
    return _actions(node.get_topic_names_and_types())
