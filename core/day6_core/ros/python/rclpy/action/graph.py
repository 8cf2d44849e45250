"""The actions of the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rclpy._day6.incidental import also

if TYPE_CHECKING:
    from rclpy._day6.node_graph import NamesAndTypes
    from rclpy.node import Node

__getattr__ = also(__name__, "Node")


def get_action_client_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return the actions a node is a client of.

    Raises:
        RCLError: if there is no such node.
    """
    return node._rclpy_graph.get_action_client_names_and_types_by_node(remote_node_name, remote_node_namespace)


def get_action_server_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return the actions a node serves.

    Raises:
        RCLError: if there is no such node.
    """
    return node._rclpy_graph.get_action_server_names_and_types_by_node(remote_node_name, remote_node_namespace)


def get_action_names_and_types(node: Node) -> NamesAndTypes:
    """Return all actions with their types."""
    return node._rclpy_graph.get_action_names_and_types()
