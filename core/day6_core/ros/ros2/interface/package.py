"""`ros2 interface package`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import interface_packages
from day6_core.ros.ros2.cli.options import completed
from day6_core.ros.ros2.interface.list import add_kind_options

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of available interface types within one package"


def add_arguments(parser: ArgumentParser) -> None:
    add_kind_options(parser)
    completed(
        parser.add_argument("package_name", help="Name of the ROS package (e.g. 'example_interfaces')"),
        interface_packages,
    )


async def main(session: Session, args: Namespace) -> str | None:
    from rosidl_runtime_py.get_interfaces import get_interfaces

    if not args.package_name:
        raise AssertionError("The resource name must not be empty")  # as in the ament index
    wanted = {"msg": args.only_msgs, "srv": args.only_srvs, "action": args.only_actions}
    try:
        found = get_interfaces([args.package_name], session.env)
    except LookupError as error:
        return str(error)
    kinds = [kind for kind, chosen in wanted.items() if chosen] or list(wanted)
    names = sorted(found.get(args.package_name, ()), key=lambda name: (kinds_order(name), name))
    for name in names:
        if name.partition("/")[0] in kinds:
            session.print(f"{args.package_name}/{name}")
    return None


def kinds_order(name: str) -> int:
    """Return the sort key of a name: messages first, then services, then actions."""
    return ("msg", "srv", "action").index(name.partition("/")[0])
