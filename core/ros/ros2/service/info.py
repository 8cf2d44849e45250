"""`ros2 service info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_tui.core.ros.ros2.cli.completion import service_names
from day6_tui.core.ros.ros2.cli.node import graph_node, services
from day6_tui.core.ros.ros2.cli.options import add_strategy_options, completed

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

SUMMARY = "Print information about a service"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    completed(
        parser.add_argument("service_name", help="Name of the ROS service to get info (e.g. '/add_two_ints')"),
        service_names,
    )


async def main(session: Session, args: Namespace) -> str | None:
    async with graph_node(session, args) as node:
        name = args.service_name
        types = dict(services(node, hidden=args.include_hidden_services)).get(name)
        if types is None:
            return f"Unknown service '{name}'"
        session.print(f"Type: {types[0] if len(types) == 1 else types}")
        session.print(f"Clients count: {node.count_clients(name)}")
        session.print(f"Services count: {node.count_services(name)}")
    return None
