"""The actions of the graph, read from the feedback topics, as in rcl_action."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.graph import EndpointKind
from rclpy._day6.incidental import also
from rclpy._rclpy_pybind11 import RCLError

if TYPE_CHECKING:
    from rclpy.node import Node

__getattr__ = also(__name__, "Node")


_FEEDBACK = "/_action/feedback"
_MESSAGE = "_FeedbackMessage"


def _actions(topics: list[tuple[str, list[str]]]) -> list[tuple[str, list[str]]]:
    return [
        (name.removesuffix(_FEEDBACK), [each.removesuffix(_MESSAGE) for each in types])
        for name, types in topics
        if name.endswith(_FEEDBACK)
    ]


def _of_node(node: Node, name: str, namespace: str, kind: EndpointKind, what: str) -> list[tuple[str, list[str]]]:
    failed = f"Failed to get action {what} names and type"
    node.handle.check_valid(failed)
    graph = node.handle.node.graph
    nodes = graph.find_nodes(name, namespace)
    if not nodes:
        raise RCLError(f"{failed}: error not set")
    found: dict[str, list[str]] = {}
    for each in nodes:
        found.update(graph.names_and_types_by_node(each, kind))
    return _actions(sorted(found.items()))


def get_action_client_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> list[tuple[str, list[str]]]:
    """Return the actions a node is a client of.

    Raises:
        RCLError: if there is no such node.
    """
    return _of_node(node, remote_node_name, remote_node_namespace, EndpointKind.SUBSCRIPTION, "client")


def get_action_server_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> list[tuple[str, list[str]]]:
    """Return the actions a node serves.

    Raises:
        RCLError: if there is no such node.
    """
    return _of_node(node, remote_node_name, remote_node_namespace, EndpointKind.PUBLISHER, "server")


def get_action_names_and_types(node: Node) -> list[tuple[str, list[str]]]:
    """Return all actions with their types."""
    return _actions(node.get_topic_names_and_types())
