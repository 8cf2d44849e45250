"""`ros2 daemon status`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli import daemon
from day6_core.ros.ros2.cli.node import settle

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output the status of the daemon"


def add_arguments(parser: ArgumentParser) -> None:
    """It has none."""


async def main(session: Session, args: Namespace) -> None:
    await settle(session)
    session.print("The daemon is running" if daemon.is_running(session) else "The daemon is not running")
