"""`ros2 interface list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "List all interface types available"


def add_arguments(parser: ArgumentParser) -> None:
    add_kind_options(parser)


def add_kind_options(parser: ArgumentParser) -> None:
    """Add the three options that choose messages, services or actions."""
    parser.add_argument("-m", "--only-msgs", action="store_true", help="Print out only the message types")
    parser.add_argument("-s", "--only-srvs", action="store_true", help="Print out only the service types")
    parser.add_argument("-a", "--only-actions", action="store_true", help="Print out only the action types")


def interface_names(environment: Mapping[str, str]) -> list[str]:
    """Return the types of all messages, services and actions, sorted."""
    import rosidl_runtime_py as lookup

    kinds = (lookup.get_message_interfaces, lookup.get_service_interfaces, lookup.get_action_interfaces)
    return sorted(
        f"{package}/{name}"
        for interfaces in kinds
        for package, names in interfaces(environment=environment).items()
        for name in names
    )


async def main(session: Session, args: Namespace) -> None:
    import rosidl_runtime_py as lookup

    sections = {
        "Messages": (args.only_msgs, lookup.get_message_interfaces),
        "Services": (args.only_srvs, lookup.get_service_interfaces),
        "Actions": (args.only_actions, lookup.get_action_interfaces),
    }
    everything = not any(wanted for wanted, _ in sections.values())
    for title, (wanted, interfaces) in sections.items():
        if wanted or everything:
            session.print(f"{title}:")
            for package, names in sorted(interfaces(environment=session.env).items()):
                for name in sorted(names):
                    session.print(f"    {package}/{name}")
