"""`ros2 daemon start`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli import daemon
from day6_core.ros.ros2.cli.node import settle

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Start the daemon if it isn't running"


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("--debug", "-d", action="store_true", help="Print debug messages")


async def main(session: Session, args: Namespace) -> str | None:
    await settle(session)
    if daemon.is_running(session):
        session.print("The daemon is already running")
    elif daemon.start(session):
        session.print("The daemon has been started")
    else:
        return "no daemon is needed here: it runs inside day6-tui while the desktop is open"
    return None
