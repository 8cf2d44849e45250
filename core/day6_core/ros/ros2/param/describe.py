"""`ros2 param describe`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli import completion
from day6_core.ros.ros2.cli.options import add_hidden_option, completed
from day6_core.ros.ros2.param._services import (
    ParameterServices,
    add_node_argument,
    add_timeout_option,
    found_node,
)
from day6_core.ros.ros2.param._values import type_name

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Show descriptive information about declared parameters"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    add_hidden_option(parser, "nodes")
    completed(
        parser.add_argument("parameter_names", nargs="+", help="Names of the parameters"), completion.parameter_names
    )
    add_timeout_option(parser)


async def main(session: Session, args: Namespace) -> str | None:
    if not await found_node(session, args):
        return "Node not found"
    services = await ParameterServices.of(session, args, args.node_name)
    response = await services.call("DescribeParameters", names=args.parameter_names)
    for descriptor in response.descriptors:
        _print(session, descriptor)
    return None


def _print(session: Session, descriptor: Any) -> None:
    session.print("Parameter name:", descriptor.name)
    session.print("  Type:", type_name(descriptor.type))
    if descriptor.description:
        session.print("  Description:", descriptor.description)
    session.print("  Constraints:")
    if descriptor.read_only:
        session.print("    Read only: true")
    for limits in [*descriptor.floating_point_range, *descriptor.integer_range][:1]:
        session.print("    Min value:", limits.from_value)
        session.print("    Max value:", limits.to_value)
        if limits.step:
            session.print("    Step:", limits.step)
    if descriptor.additional_constraints:
        session.print("    Additional constraints:", descriptor.additional_constraints)
