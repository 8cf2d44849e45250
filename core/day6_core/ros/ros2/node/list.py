"""`ros2 node list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.node import graph_node, node_names
from day6_core.ros.ros2.cli.options import add_strategy_options

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of available nodes"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    parser.add_argument("-a", "--all", action="store_true", help="Display all nodes even hidden ones")
    parser.add_argument("-c", "--count-nodes", action="store_true", help="Only display the number of nodes discovered")


async def main(session: Session, args: Namespace) -> None:
    async with graph_node(session, args) as node:
        names = sorted(node_names(node, hidden=args.all))
    if args.count_nodes:
        session.print(len(names))
        return
    if len(set(names)) < len(names):
        session.print_error(value("ros2.same_names"))
    for name in names:
        session.print(name)
