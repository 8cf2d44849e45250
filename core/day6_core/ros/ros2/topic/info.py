"""`ros2 topic info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.choice import choose_topic, may_be_left_out
from day6_core.ros.ros2.cli.completion import topic_names
from day6_core.ros.ros2.cli.node import graph_node
from day6_core.ros.ros2.cli.options import add_strategy_options, completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Print information about a topic"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    completed(
        parser.add_argument(
            "topic_name", nargs=may_be_left_out(), help="Name of the ROS topic to get info (e.g. '/chatter')"
        ),
        topic_names,
    )
    parser.add_argument(
        "--verbose",
        "-v",
        action="store_true",
        help="Prints detailed information like the node name, node namespace, topic type, topic type hash, GUID, and QoS "
        "Profile of the publishers and subscribers to this topic",
    )


async def main(session: Session, args: Namespace) -> str | None:
    async with graph_node(session, args) as node:
        name = args.topic_name or await choose_topic(session, args, node, "Select topic for info:")
        types = dict(node.get_topic_names_and_types()).get(name)
        if types is None:
            return f"Unknown topic '{name}'"
        end = "\n\n" if args.verbose else "\n"
        session.print(f"Type: {types[0] if len(types) == 1 else types}", end=end)
        session.print(f"Publisher count: {node.count_publishers(name)}", end=end)
        if args.verbose:
            for endpoint in node.get_publishers_info_by_topic(name):
                session.print(endpoint, end=end)
        session.print(f"Subscription count: {node.count_subscribers(name)}", end=end)
        if args.verbose:
            for endpoint in node.get_subscriptions_info_by_topic(name):
                session.print(endpoint, end=end)
    return None
