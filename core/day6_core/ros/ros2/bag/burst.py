"""`ros2 bag burst`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.bag._options import add_bag_path, add_qos_overrides, event_topics, not_negative_int
from day6_core.ros.ros2.bag.play import add_reading, add_remapping

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Burst data from a bag"


def add_arguments(parser: ArgumentParser) -> None:
    add_bag_path(parser)
    add_reading(parser)
    for things in ("topic", "service", "action"):
        parser.add_argument(
            f"--{things}s",
            default=[],
            nargs="+",
            help=f"{things}s to replay, separated by space. At least one {things} needs to be specified. If this parameter "
            f"isn't specified, all {things}s will be replayed.",
        )
    add_qos_overrides(parser)
    add_remapping(parser)
    parser.add_argument(
        "-n",
        "--num-messages",
        type=not_negative_int,
        default=0,
        help="Burst the specified number of messages, then pause.",
    )


async def main(session: Session, args: Namespace) -> str | None:
    from rosbag2_py._options import PlayOptions

    from day6_core.ros.ros2.bag._player import play

    options = PlayOptions(
        topics_to_filter=args.topics,
        services_to_filter=event_topics(args.services),
        actions_to_filter=args.actions,
        start_paused=True,
        start_offset=args.start_offset,
    )
    inputs = [[args.bag_path, *([args.storage] if args.storage else [])]]
    return await play(session, inputs, options, args, burst=args.num_messages)
