"""`ros2 topic type`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.choice import choose_topic, may_be_left_out
from day6_core.ros.ros2.cli.completion import topic_names
from day6_core.ros.ros2.cli.node import graph_node, topics
from day6_core.ros.ros2.cli.options import add_strategy_options, completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Print a topic's type"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    completed(
        parser.add_argument(
            "topic_name", nargs=may_be_left_out(), help="Name of the ROS topic to get type (e.g. '/chatter')"
        ),
        topic_names,
    )


async def main(session: Session, args: Namespace) -> int:
    async with graph_node(session, args) as node:
        name = args.topic_name or await choose_topic(session, args, node, "Select topic:")
        types = dict(topics(node, hidden=args.include_hidden_topics)).get(name)
    for each in types or ():
        session.print(each)
    return 1 if types is None else 0
