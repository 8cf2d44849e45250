"""`ros2 service info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.completion import service_names
from day6_core.ros.ros2.cli.node import graph_node, services
from day6_core.ros.ros2.cli.options import add_strategy_options, completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Print information about a service"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    completed(
        parser.add_argument("service_name", help="Name of the ROS service to get info (e.g. '/add_two_ints')"),
        service_names,
    )
    if value("service.info_verbose"):
        parser.add_argument(
            "-v",
            "--verbose",
            action="store_true",
            help="Also print node, type hash, GIDs and QoS of clients and servers",
        )


async def main(session: Session, args: Namespace) -> str | None:
    async with graph_node(session, args) as node:
        name = args.service_name
        types = dict(services(node, hidden=args.include_hidden_services)).get(name)
        if types is None:
            return f"Unknown service '{name}'"
        session.print(f"Type: {types[0] if len(types) == 1 else types}")
        verbose = value("service.info_verbose") and args.verbose
        session.print(f"Clients count: {node.count_clients(name)}")
        for client in node.get_clients_info_by_service(name) if verbose else ():
            session.print(str(client))
        session.print(f"Services count: {node.count_services(name)}")
        for server in node.get_servers_info_by_service(name) if verbose else ():
            session.print(str(server))
    return None
