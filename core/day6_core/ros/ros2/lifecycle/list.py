"""`ros2 lifecycle list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.node import absolute
from day6_core.ros.ros2.lifecycle._services import LifecycleServices, add_node_argument, lifecycle_nodes
from day6_core.session.harmless import in_a_list

if TYPE_CHECKING:
    from day6_core.session.session import Session

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
        labels = (each.transition.label, each.start_state.label, each.goal_state.label)
        transition, start, goal = (in_a_list(label, session.stdout) for label in labels)
        session.print(f"- {transition} [{each.transition.id}]\n\tStart: {start}\n\tGoal: {goal}")
    return None
