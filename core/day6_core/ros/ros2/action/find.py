"""`ros2 action find`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import action_types
from day6_core.ros.ros2.cli.node import graph_node
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Find actions from type"


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument(
            "action_type", help="Name of the ROS action type to find (e.g. 'test_msgs/action/Fibonacci')"
        ),
        action_types,
    )
    parser.add_argument(
        "-c", "--count-actions", action="store_true", help="Only display the number of actions discovered"
    )


async def main(session: Session, args: Namespace) -> None:
    from rclpy.action import get_action_names_and_types

    async with graph_node(session, args) as node:
        found = [name for name, types in get_action_names_and_types(node) if args.action_type in types]
    if args.count_actions:
        session.print(len(found))
        return
    for name in found:
        session.print(name)
