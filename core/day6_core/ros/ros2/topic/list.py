"""`ros2 topic list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.node import graph_node, topics
from day6_core.ros.ros2.cli.options import add_hidden_option, add_strategy_options

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of available topics"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    parser.add_argument("-t", "--show-types", action="store_true", help="Additionally show the topic type")
    parser.add_argument(
        "-c", "--count-topics", action="store_true", help="Only display the number of topics discovered"
    )
    add_hidden_option(parser, "topics")
    parser.add_argument("-v", "--verbose", action="store_true", help="List full details about each topic")


async def main(session: Session, args: Namespace) -> None:
    async with graph_node(session, args) as node:
        found = topics(node, hidden=args.include_hidden_topics)
        publishers = {name: node.count_publishers(name) for name, _ in found} if args.verbose else {}
        subscribers = {name: node.count_subscribers(name) for name, _ in found} if args.verbose else {}
    if args.count_topics:
        session.print(len(found))
    elif args.verbose and found:
        session.print(_section("Published topics:", found, publishers, "publisher"))
        session.print(_section("Subscribed topics:", found, subscribers, "subscriber"))
    elif not args.verbose:
        for name, types in found:
            session.print(f"{name} [{', '.join(types)}]" if args.show_types else name)


def _section(title: str, found: list[tuple[str, list[str]]], counts: dict[str, int], one: str) -> str:
    lines = [title]
    for name, types in found:
        count = counts[name]
        if count:
            lines.append(f" * {name} [{', '.join(types)}] {count} {one}{'s' if count > 1 else ''}")
    return "\n".join(lines) + "\n"
