"""`ros2 action info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.completion import action_names
from day6_core.ros.ros2.cli.node import graph_node
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

SUMMARY = "Print information about an action"


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument("action_name", help="Name of the ROS action to get info (e.g. '/fibonacci')"), action_names
    )
    parser.add_argument("-t", "--show-types", action="store_true", help="Additionally show the action type")
    parser.add_argument(
        "-c",
        "--count",
        action="store_true",
        help="Only display the number of action clients and action servers",
    )


async def main(session: Session, args: Namespace) -> None:
    async with graph_node(session, args) as node:
        full_name = _full_name(node, args.action_name)
        found = {"Action clients": clients(node, full_name), "Action servers": servers(node, full_name)}
    session.print(f"Action: {args.action_name}")
    for title, owners in found.items():
        session.print(f"{title}: {len(owners)}")
        if not args.count:
            for owner, types in owners:
                session.print(f"    {owner} [{', '.join(types)}]" if args.show_types else f"    {owner}")


def _full_name(node: Node, action_name: str) -> str:
    from rclpy.exceptions import InvalidTopicNameException
    from rclpy.expand_topic_name import expand_topic_name
    from rclpy.validate_full_topic_name import validate_full_topic_name

    try:
        full_name = str(expand_topic_name(action_name, node.get_name(), node.get_namespace()))
        validate_full_topic_name(full_name)
    except (ValueError, InvalidTopicNameException) as error:
        raise RuntimeError(error) from None
    return full_name


def clients(node: Node, action: str) -> list[tuple[str, list[str]]]:
    """Return `(node, types)` of the nodes that have a client of an action."""
    from rclpy.action import get_action_client_names_and_types_by_node

    return _owners(node, action, get_action_client_names_and_types_by_node)


def servers(node: Node, action: str) -> list[tuple[str, list[str]]]:
    """Return `(node, types)` of the nodes that have a server of an action."""
    from rclpy.action import get_action_server_names_and_types_by_node

    return _owners(node, action, get_action_server_names_and_types_by_node)


def _owners(node: Node, action: str, names_and_types: Callable[..., Any]) -> list[tuple[str, list[str]]]:
    """Return `(node, types)` of the nodes that have a client or a server of the action."""
    return [
        (f"{value('action.root_node') if namespace == '/' else namespace + '/'}{name}", types)
        for name, namespace in node.get_node_names_and_namespaces()
        for found, types in names_and_types(node, name, namespace)
        if found == action
    ]
