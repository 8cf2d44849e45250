"""`ros2 service list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.node import graph_node, services
from day6_core.ros.ros2.cli.options import add_hidden_option, add_strategy_options

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of available services"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    parser.add_argument("-t", "--show-types", action="store_true", help="Additionally show the service type")
    parser.add_argument(
        "-c", "--count-services", action="store_true", help="Only display the number of services discovered"
    )
    add_hidden_option(parser, "services")


async def main(session: Session, args: Namespace) -> None:
    async with graph_node(session, args) as node:
        found = services(node, hidden=args.include_hidden_services)
    if args.count_services:
        session.print(len(found))
        return
    for name, types in found:
        session.print(f"{name} [{', '.join(types)}]" if args.show_types else name)
