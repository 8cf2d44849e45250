"""`ros2 pkg list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

SUMMARY = "Output a list of available packages"


def add_arguments(parser: ArgumentParser) -> None:
    """It has none."""


async def main(session: Session, args: Namespace) -> None:
    from day6_tui.core.ros.ros2.pkg._index import packages

    for name in packages(session):
        session.print(name)
