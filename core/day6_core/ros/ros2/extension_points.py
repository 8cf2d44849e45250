"""`ros2 extension_points`: the groups in which commands and verbs are registered."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "List extension points"
VERSION = "0.1"
_WORDS = {"component": "node", "multicast": "msg"}
"""The real packages' words for their verbs where they differ from the command's name."""


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--all",
        "-a",
        action="store_true",
        help="Also show extension points which failed to be imported. (prefixed with `- `)",
    )
    parser.add_argument("--verbose", "-v", action="store_true", help="Show more information for each extension point")


async def main(session: Session, args: Namespace) -> None:
    from day6_core.ros.ros2.extensions import groups

    for group in groups():
        session.print(f"{group}: {_description(group)}")
        if args.verbose:
            session.print("   version:", VERSION)


def _description(group: str) -> str:
    if group == "ros2cli.command":
        return "The extension point for 'command' extensions"
    command = "daemon" if group == "ros2cli.daemon.verb" else group.removesuffix(".verb").removeprefix("ros2")
    article = "Extension" if command == "interface" else "The extension"
    return f"{article} point for '{_WORDS.get(command, command)}' verb extensions"
