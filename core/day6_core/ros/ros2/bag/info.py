"""`ros2 bag info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.ros.ros2.bag._options import add_bag_path, console

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Print information about a bag to the screen"


def add_arguments(parser: ArgumentParser) -> None:
    add_bag_path(parser)
    parser.add_argument("-t", "--topic-name", action="store_true", help="Only display topic names.")
    parser.add_argument(
        "-v", "--verbose", action="store_true", help="Display request/response information for services"
    )
    parser.add_argument(
        "--sort",
        default="name",
        choices=("name", "type", "count"),
        help="Configuration for sorting of output. By default sorts by topic name - use this argument to override.",
    )


async def main(session: Session, args: Namespace) -> None:
    from rosbag2_py._info import Info

    if args.topic_name and args.verbose:
        session.print("Warning! You have set both the '-t' and '-v' parameters. The '-t' parameter will be ignored.")
    info = Info(console(session, args.bag_path))
    path = str(Path(session.cwd, args.bag_path))
    try:
        metadata = info.read_metadata(path, args.storage)
    except RuntimeError as error:
        # Show the path as the user typed it, not as we resolved it.
        raise RuntimeError(str(error).replace(path, args.bag_path)) from None
    if args.verbose:
        session.print(info.verbose_text(path, metadata, args.sort))
    elif args.topic_name:
        for name in info.topic_names(metadata, args.sort):
            session.print(name)
    else:
        session.print(info.text(metadata, args.sort))
