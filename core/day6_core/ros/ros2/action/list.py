"""`ros2 action list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.node import graph_node

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of action names"


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("-t", "--show-types", action="store_true", help="Additionally show the action type")
    parser.add_argument(
        "-c", "--count-actions", action="store_true", help="Only display the number of actions discovered"
    )


async def main(session: Session, args: Namespace) -> None:
    from rclpy.action import get_action_names_and_types

    async with graph_node(session, args) as node:
        found = get_action_names_and_types(node)
    if args.count_actions:
        session.print(len(found))
        return
    for name, types in found:
        session.print(f"{name} [{', '.join(types)}]" if args.show_types else name)
