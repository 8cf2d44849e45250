"""`ros2 daemon start`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli import daemon
from day6_core.ros.ros2.cli.node import settle

if TYPE_CHECKING:
    from day6_core.session.session import Session

LONGEST_SECONDS = 10.0
SUMMARY = "Start the daemon if it isn't running"


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("--debug", "-d", action="store_true", help="Print debug messages")


async def main(session: Session, args: Namespace) -> None:
    await settle(session)
    new = not daemon.is_running(session) and (daemon.start(session) or await _start_alone(session, args))
    session.print("The daemon has been started" if new else "The daemon is already running")


async def _start_alone(session: Session, args: Namespace) -> bool:
    from day6_core.ros.ros2.cli.lone_daemon import spawn
    from day6_core.session.threads import in_thread

    domain = session.graph.domain_id if session.graph is not None else 0
    return await in_thread(lambda: spawn(domain, LONGEST_SECONDS, debug=args.debug))
