"""`ros2 lifecycle list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_tui.core.ros.ros2.cli.node import absolute
from day6_tui.core.ros.ros2.lifecycle._services import LifecycleServices, add_node_argument, lifecycle_nodes

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

SUMMARY = "Output a list of available transitions"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    parser.add_argument("-a", "--all", action="store_true", help="Display all existing transitions")


async def main(session: Session, args: Namespace) -> str | None:
    name = absolute(args.node_name)
    if name not in await lifecycle_nodes(session, args, hidden=args.include_hidden_nodes):
        return "Node not found"
    services = await LifecycleServices.of(session, args)
    try:
        transitions = await services.transitions(name, graph=args.all)
    except RuntimeError as error:
        return f"Exception while calling service of node '{args.node_name}': {error}"
    for each in transitions:
        session.print(
            f"- {each.transition.label} [{each.transition.id}]\n"
            f"\tStart: {each.start_state.label}\n\tGoal: {each.goal_state.label}"
        )
    return None
