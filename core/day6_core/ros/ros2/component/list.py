"""`ros2 component list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.options import add_response_timeout, add_strategy_options
from day6_core.ros.ros2.component._container import Container, add_container_argument, containers
from day6_core.session.harmless import in_a_list

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of running containers and components"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    add_container_argument(parser, "Name of the container node to list components from", nargs="?")
    parser.add_argument("--containers-only", action="store_true", help="List found containers nodes only")
    add_response_timeout(parser)


async def main(session: Session, args: Namespace) -> str | None:
    found = await containers(session, args)
    wanted = args.container_node_name
    if wanted is not None:
        if wanted not in found:
            return f"Unable to find container node '{wanted}'"
        return None if args.containers_only else await _print(session, args, wanted, "", f" in {wanted}")
    for name in found:
        session.print(name)
        if not args.containers_only:
            problem = await _print(session, args, name, "  ", "")
            if problem is not None:
                session.print(problem)
    return None


async def _print(session: Session, args: Namespace, name: str, indent: str, where: str) -> str | None:
    """Print the components of a container, or return what went wrong."""
    async with Container.of(session, args, name) as container:
        try:
            components = await container.components()
        except TimeoutError as error:
            return f"No 'list_nodes' {error} when listing components{where}"
    for number, node_name in components:
        session.print(f"{indent}{number}  {in_a_list(node_name, session.stdout)}")
    return None
