"""`ros2 pkg prefix`.

The true prefix, as in every path that a program may open (`get_package_share_directory`, errors of ament_index):
`cat $(ros2 pkg prefix turtlesim)/share/turtlesim/package.xml` has to work. `/opt/ros/<distribution>` stands only where nothing is
opened: in what is sourced, and in what `which` answers.
"""

from __future__ import annotations

import os
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import package_names
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output the prefix path of a package"


def add_arguments(parser: ArgumentParser) -> None:
    completed(parser.add_argument("package_name", help="The package name"), package_names)
    parser.add_argument("--share", action="store_true", help="Show share directory for the package")


async def main(session: Session, args: Namespace) -> str | None:
    from day6_core.ros.ros2.cli.packages import prefix_of

    prefix = prefix_of(session, args.package_name)
    if prefix is None:
        return "Package not found"
    session.print(os.path.join(prefix, "share", args.package_name) if args.share else prefix)
    return None
