"""`ros2 service find`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import service_types
from day6_core.ros.ros2.cli.node import graph_node, services
from day6_core.ros.ros2.cli.options import add_hidden_option, completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of available services of a given type"


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument(
            "service_type",
            help="Name of the ROS service type to filter for (e.g. 'rcl_interfaces/srv/ListParameters')",
        ),
        service_types,
    )
    parser.add_argument(
        "-c", "--count-services", action="store_true", help="Only display the number of services discovered"
    )
    add_hidden_option(parser, "services")


async def main(session: Session, args: Namespace) -> None:
    async with graph_node(session, args) as node:
        offered = services(node, hidden=args.include_hidden_services)
    found = [name for name, types in offered if args.service_type in types]
    if args.count_services:
        session.print(len(found))
        return
    for name in found:
        session.print(name)
