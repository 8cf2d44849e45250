"""`ros2 component unload`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.options import add_response_timeout, add_strategy_options
from day6_core.ros.ros2.component._container import Container, add_container_argument, containers

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Unload a component from a container node"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    add_container_argument(parser, "Container node name to unload component from")
    parser.add_argument("component_uid", type=int, nargs="+", help="Unique ID of the component to be unloaded")
    parser.add_argument("-q", "--quiet", action="store_true", help="Only print component unique IDs")
    add_response_timeout(parser)


async def main(session: Session, args: Namespace) -> str | None:
    name = args.container_node_name
    if name not in await containers(session, args):
        return f"Unable to find container node '{name}'"
    async with Container.of(session, args, name) as container:
        for number in args.component_uid:
            reason = await container.unload(number)
            if reason is not None:
                return f"Failed to unload component {number} from '{name}' container node\n    {reason.capitalize()}"
            session.print(number if args.quiet else f"Unloaded component {number} from '{name}' container node")
    return None
