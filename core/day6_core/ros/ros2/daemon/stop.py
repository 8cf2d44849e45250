"""`ros2 daemon stop`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli import daemon
from day6_core.ros.ros2.cli.node import settle

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Stop the daemon if it is running"


def add_arguments(parser: ArgumentParser) -> None:
    """It has none."""


async def main(session: Session, args: Namespace) -> str | None:
    await settle(session)
    if daemon.stop(session):
        session.print("The daemon has been stopped")
    elif daemon.is_running(session):
        return "the daemon belongs to another day6-tui: stop it in a terminal there"
    else:
        session.print("The daemon is not running")
    return None
