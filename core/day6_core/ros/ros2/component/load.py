"""`ros2 component load`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.options import add_response_timeout, add_strategy_options
from day6_core.ros.ros2.component._container import (
    Container,
    add_component_arguments,
    add_container_argument,
    containers,
)

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Load a component into a container node"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    add_container_argument(parser, "Container node name to load component into")
    add_component_arguments(parser)
    parser.add_argument("-q", "--quiet", action="store_true", help="Only print component unique IDs and names")
    add_response_timeout(parser)


async def main(session: Session, args: Namespace) -> str | None:
    name = args.container_node_name
    if name not in await containers(session, args):
        return f"Unable to find container node '{name}'"
    async with Container.of(session, args, name) as container:
        number, node_name = await container.load(args)
    if args.quiet:
        session.print(f"{number}  {node_name}")
    else:
        session.print(f"Loaded component {number} into '{name}' container node as '{node_name}'")
    return None
