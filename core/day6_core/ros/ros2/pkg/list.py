"""`ros2 pkg list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from ament_index_python.search_paths import BUILT_IN_PREFIX

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of available packages"


def add_arguments(parser: ArgumentParser) -> None:
    """It has none."""


async def main(session: Session, args: Namespace) -> None:
    from day6_core.ros.ros2.cli.packages import packages, prefix_of

    for name in packages(session):
        # Real ROS doesn't have our examples: `ros2 pkg list | grep day6` has to find the student's packages only.
        if not (name.startswith("day6_") and prefix_of(session, name) == BUILT_IN_PREFIX):
            session.print(name)
