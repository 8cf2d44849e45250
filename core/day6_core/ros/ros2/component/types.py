"""`ros2 component types`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli import completion
from day6_core.ros.ros2.cli.options import completed
from day6_core.ros.ros2.component._index import component_types, packages_with_components

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of components registered in the ament index"


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument("package_name", nargs="?", help="Package name to look for registered components in"),
        completion.package_names,
    )


async def main(session: Session, args: Namespace) -> str | None:
    from day6_core.ros.ros2.cli.packages import packages

    if args.package_name is not None:
        if args.package_name not in packages(session):
            return f"Unable to find package '{args.package_name}'"
        session.print(*component_types(session, args.package_name), sep="\n")
        return None
    for package in packages_with_components(session):
        session.print(package)
        session.print(*(f"  {each}" for each in component_types(session, package)), sep="\n")
    return None
