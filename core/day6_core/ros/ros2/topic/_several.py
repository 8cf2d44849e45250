"""Several topics at once, in `ros2 topic hz` and `ros2 topic bw`: how they are chosen, and the table of them."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.choice import choose_topic
from day6_core.ros.ros2.cli.completion import topic_names
from day6_core.ros.ros2.cli.node import settle, topics
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

_CLEAR = "\x1b[H\x1b[2J"


def add_topics(parser: ArgumentParser, dest: str, words: str, *, several: bool, everything: bool) -> None:
    """Add the topic or topics, and `--all` where there is that."""
    if not several:
        completed(parser.add_argument(dest, help=words), topic_names)
        return
    completed(parser.add_argument(dest, nargs="*" if everything else "+", help=words), topic_names)
    if everything:
        parser.add_argument(
            "-a", "--all", dest="all_topics", action="store_true", help="Listen to all topics that there are now"
        )


async def chosen_topics(session: Session, node: Node, args: Namespace, dest: str) -> list[str]:
    """Return the topics to listen to, given as `dest`, chosen, or all. Raises RuntimeError, NothingChosen."""
    given: str | list[str] = getattr(args, dest)
    if isinstance(given, str):
        return [given]
    if not getattr(args, "all_topics", False):
        return given or [await choose_topic(session, args, node, "Select topic:")]
    if given:
        raise RuntimeError("Cannot specify both --all/-a and topic names")
    await settle(session)
    found = [name for name, _ in topics(node, hidden=args.include_hidden_topics)]
    session.print(f"Subscribing to all {len(found)} available topics..." if found else "No topics available")
    return found


def clear_above(session: Session, args: Namespace) -> None:
    """Clear the screen for the next table of all topics."""
    if getattr(args, "all_topics", False) and session.stdout.isatty():
        session.stdout.control(_CLEAR)


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return lines with a rule below the header, and an empty one at the end."""
    widths = [max(map(len, column)) for column in zip(header, *rows, strict=True)]
    lines = [
        "   ".join(word.center(width) for word, width in zip(header, widths, strict=True)),
        "=" * (sum(widths) + 3 * (len(widths) - 1)),
        *("   ".join(word.ljust(width) for word, width in zip(row, widths, strict=True)) for row in rows),
    ]
    return "\n".join(lines) + "\n"
