"""`ros2 multicast receive`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.multicast import LARGEST, add_group_arguments, member

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Receive a single UDP multicast packet"
POLL_SECONDS = 0.05


def add_arguments(parser: ArgumentParser) -> None:
    add_group_arguments(parser)


async def main(session: Session, args: Namespace) -> None:
    session.print("Waiting for UDP multicast datagram...")
    with member(args.group, args.port) as receiver:
        while True:
            try:
                data, (host, port) = receiver.recvfrom(LARGEST)
                break
            except BlockingIOError:
                try:
                    await session.sleep(POLL_SECONDS)
                except KeyboardInterrupt:
                    return
    session.print(f"Received from {host}:{port}: '{data.decode('utf-8')}'")
