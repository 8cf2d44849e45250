"""`ros2 lifecycle nodes`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.options import add_strategy_options
from day6_core.ros.ros2.lifecycle._services import lifecycle_nodes

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of nodes with lifecycle"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    parser.add_argument("-a", "--all", action="store_true", help="Display all nodes even hidden ones")
    parser.add_argument("-c", "--count-nodes", action="store_true", help="Only display the number of nodes discovered")


async def main(session: Session, args: Namespace) -> None:
    names = await lifecycle_nodes(session, args, hidden=args.all)
    if args.count_nodes:
        session.print(len(names))
        return
    for name in sorted(set(names)):
        session.print(name)
