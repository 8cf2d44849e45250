"""`ros2 interface proto`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.completion import interface_types
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output an interface prototype"


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument("type", help="Show an interface definition (e.g. 'example_interfaces/msg/String')"),
        interface_types,
    )
    parser.add_argument("--no-quotes", action="store_true", help="if true output has no outer quotes.")


async def main(session: Session, args: Namespace) -> None:
    from rosidl_runtime_py.convert import message_to_yaml
    from rosidl_runtime_py.utilities import get_interface, is_action, is_service

    kind = get_interface(args.type)
    part = kind.Goal if is_action(kind) else kind.Request if is_service(kind) else kind
    text = message_to_yaml(part())
    session.print(text if args.no_quotes else f'"{text}"')
