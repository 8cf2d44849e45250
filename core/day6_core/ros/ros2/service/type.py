"""`ros2 service type`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import service_names
from day6_core.ros.ros2.cli.node import graph_node, services
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a service's type"


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument(
            "service_name", help="Name of the ROS service to get type (e.g. '/talker/list_parameters')"
        ),
        service_names,
    )


async def main(session: Session, args: Namespace) -> int:
    async with graph_node(session, args) as node:
        types = dict(services(node, hidden=args.include_hidden_services)).get(args.service_name)
    for each in types or ():
        session.print(each)
    return 1 if types is None else 0
