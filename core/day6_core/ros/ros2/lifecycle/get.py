"""`ros2 lifecycle get`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.node import absolute
from day6_core.ros.ros2.lifecycle._services import LifecycleServices, add_node_argument, lifecycle_nodes

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Get lifecycle state for one or more nodes"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(
        parser, "Name of the ROS node. If no name is provided, then get the state for all nodes.", nargs="?"
    )


async def main(session: Session, args: Namespace) -> int | str | None:
    names = sorted(set(await lifecycle_nodes(session, args, hidden=args.include_hidden_nodes)))
    if args.node_name:
        wanted = absolute(args.node_name)
        if wanted not in names:
            return "Node not found"
        names = [wanted]
    services = await LifecycleServices.of(session, args)
    lines = []
    for name in names:
        try:
            state = (await services.call(name, "get_state", "GetState")).current_state
        except RuntimeError as error:
            session.print_error(f"Exception while calling service of node '{name}': {error}")
            if args.node_name:
                return 1
            continue
        lines.append(f"{'' if args.node_name else f'{name}: '}{state.label} [{state.id}]")
    for line in lines:
        session.print(line)
    return None
