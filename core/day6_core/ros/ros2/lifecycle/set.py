"""`ros2 lifecycle set`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.node import absolute
from day6_core.ros.ros2.cli.options import completed
from day6_core.ros.ros2.lifecycle._services import (
    LifecycleServices,
    add_node_argument,
    lifecycle_nodes,
    transition_labels,
)

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Trigger lifecycle state transition"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    completed(parser.add_argument("transition", help="The lifecycle transition"), transition_labels)


async def main(session: Session, args: Namespace) -> str | None:
    name = absolute(args.node_name)
    if name not in await lifecycle_nodes(session, args, hidden=args.include_hidden_nodes):
        return "Node not found"
    services = await LifecycleServices.of(session, args)
    try:
        possible = [each.transition for each in await services.transitions(name)]
    except RuntimeError as error:
        return f"Exception while calling service of node '{args.node_name}': {error}"
    by_word = {**{str(each.id): each for each in possible}, **{each.label: each for each in reversed(possible)}}
    if args.transition not in by_word:
        available = "".join(f"\n- {each.label} [{each.id}]" for each in possible)
        return f"Unknown transition requested, available ones are:{available}"
    try:
        response = await services.call(name, "change_state", "ChangeState", transition=by_word[args.transition])
    except RuntimeError as error:
        session.print_error(f"Exception while calling service of node '{args.node_name}': {error}")
        return None
    if response.success:
        session.print("Transitioning successful")
    else:
        session.print_error("Transitioning failed")
    return None
