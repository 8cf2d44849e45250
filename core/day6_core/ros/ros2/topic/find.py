"""`ros2 topic find`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import message_types
from day6_core.ros.ros2.cli.node import graph_node, topics
from day6_core.ros.ros2.cli.options import add_hidden_option, add_strategy_options, completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of available topics of a given type"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    completed(
        parser.add_argument("topic_type", help="Name of the ROS topic type to filter for (e.g. 'std_msg/msg/String')"),
        message_types,
    )
    parser.add_argument(
        "-c", "--count-topics", action="store_true", help="Only display the number of topics discovered"
    )
    add_hidden_option(parser, "topics")


async def main(session: Session, args: Namespace) -> None:
    async with graph_node(session, args) as node:
        found = [name for name, types in topics(node, hidden=args.include_hidden_topics) if args.topic_type in types]
    if args.count_topics:
        session.print(len(found))
    else:
        for name in found:
            session.print(name)
