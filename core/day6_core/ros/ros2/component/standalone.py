"""`ros2 component standalone`."""

from __future__ import annotations

import os
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.options import add_strategy_options
from day6_core.ros.ros2.component._container import Container, add_component_arguments

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Run a component into its own standalone container node"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    add_component_arguments(parser)
    parser.add_argument(
        "-c",
        "--container-node-name",
        default=f"standalone_container_{os.urandom(6).hex()}",
        help="Name of the standalone container node to be run",
    )


async def main(session: Session, args: Namespace) -> int | None:
    from day6_core.ros.programs.rclcpp_components.component_manager import ComponentManager

    manager = ComponentManager(session, args.container_node_name)
    session.executor.add_node(manager.node)
    async with Container.of(session, args, args.container_node_name) as container:
        try:
            await container.load(args)
        except RuntimeError as error:
            session.print(f"{error}, interrupting container node")
            return 0
    try:
        await session.spin(manager.node)
    except KeyboardInterrupt:
        return 0
    return 0
