"""`ros2 action type`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import action_names
from day6_core.ros.ros2.cli.node import graph_node
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Print a action's type"


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument("action_name", help="Name of the ROS action to get info (e.g. '/fibonacci')"), action_names
    )


async def main(session: Session, args: Namespace) -> int:
    from rclpy.action import get_action_names_and_types

    async with graph_node(session, args) as node:
        types = dict(get_action_names_and_types(node)).get(args.action_name)
    for each in types or ():
        session.print(each)
    return 1 if types is None else 0
