"""`ros2 interface packages`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of packages that provide interfaces"


def add_arguments(parser: ArgumentParser) -> None:
    for short, long, what in (("-m", "msgs", "messages"), ("-s", "srvs", "services"), ("-a", "actions", "actions")):
        parser.add_argument(short, f"--only-{long}", action="count", help=f"Only list packages that generate {what}")


async def main(session: Session, args: Namespace) -> None:
    import rosidl_runtime_py as lookup

    if args.only_msgs:
        names = list(lookup.get_message_interfaces(environment=session.env))
    elif args.only_srvs:
        names = list(lookup.get_service_interfaces(environment=session.env))
    elif args.only_actions:
        names = list(lookup.get_action_interfaces(environment=session.env))
    else:
        names = list(lookup.get_interface_packages(session.env))
    for name in sorted(names):
        session.print(name)
