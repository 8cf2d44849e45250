"""`ros2 pkg executables`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import package_names
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of package specific executables"


def add_arguments(parser: ArgumentParser) -> None:
    completed(parser.add_argument("package_name", nargs="?", help="The package name"), package_names)
    parser.add_argument("--full-path", action="store_true", help="Show full path of each executable")


async def main(session: Session, args: Namespace) -> None:
    from day6_core.ros.ros2.cli.packages import executables, packages

    for package in packages(session) if args.package_name is None else [args.package_name]:
        found = executables(session, package)
        if found is None:
            raise RuntimeError(f"Package '{package}' not found")
        for executable in found:
            session.print(executable.path if args.full_path else f"{package} {executable.name}")
