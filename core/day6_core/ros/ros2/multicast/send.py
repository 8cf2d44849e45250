"""`ros2 multicast send`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.multicast import add_group_arguments, send
from day6_core.ros.ros2.cli.options import positive_int

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Send a single UDP multicast packet"


def add_arguments(parser: ArgumentParser) -> None:
    add_group_arguments(parser)
    parser.add_argument("--ttl", type=positive_int, help="The multicast TTL")


async def main(session: Session, args: Namespace) -> None:
    session.print("Sending one UDP multicast datagram...")
    send(b"Hello World!", args.group, args.port, args.ttl)
