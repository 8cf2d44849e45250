"""`ros2 node info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.graph.names import is_hidden
from day6_core.ros.ros2.cli import completion
from day6_core.ros.ros2.cli.choice import choose_node, may_be_left_out
from day6_core.ros.ros2.cli.node import graph_node, node_names, split_name
from day6_core.ros.ros2.cli.options import add_strategy_options, completed

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

    NamesAndTypes = Callable[[str, str], list[tuple[str, list[str]]]]

SUMMARY = "Output information about a node"
SEVERAL = (
    'There are {num_nodes} nodes in the graph with the exact name "{node_name}". '
    "You are seeing information about only one of them."
)


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    completed(
        parser.add_argument(
            "node_name", nargs=may_be_left_out(), help="Fully qualified node name to request information"
        ),
        completion.node_names,
    )
    parser.add_argument(
        "--include-hidden", action="store_true", help="Display hidden topics, services, and actions as well"
    )


async def main(session: Session, args: Namespace) -> str | None:
    async with graph_node(session, args) as node:
        if args.node_name is None:
            args.node_name = await choose_node(session, node, "Select node:", hidden=args.include_hidden)
        number = node_names(node, hidden=args.include_hidden).count(args.node_name)
        if number == 0:
            return f"Unable to find node '{args.node_name}'"
        if number > 1:
            session.print_error(SEVERAL.format(num_nodes=number, node_name=args.node_name))
        session.print(args.node_name)
        for title, names_and_types in _sections(node).items():
            session.print(f"  {title}:")
            lines = [
                f"    {name}: {', '.join(types)}"
                for name, types in names_and_types(*split_name(args.node_name))
                if args.include_hidden or not is_hidden(name)
            ]
            session.print("\n".join(lines))
    return None


def _sections(node: Node) -> dict[str, NamesAndTypes]:
    from rclpy.action import get_action_client_names_and_types_by_node, get_action_server_names_and_types_by_node

    return {
        "Subscribers": node.get_subscriber_names_and_types_by_node,
        "Publishers": node.get_publisher_names_and_types_by_node,
        "Service Servers": node.get_service_names_and_types_by_node,
        "Service Clients": node.get_client_names_and_types_by_node,
        "Action Servers": lambda name, namespace: get_action_server_names_and_types_by_node(node, name, namespace),
        "Action Clients": lambda name, namespace: get_action_client_names_and_types_by_node(node, name, namespace),
    }
