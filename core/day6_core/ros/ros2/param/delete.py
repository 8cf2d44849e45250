"""`ros2 param delete`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli import completion
from day6_core.ros.ros2.cli.options import add_hidden_option, completed
from day6_core.ros.ros2.param._services import (
    ParameterServices,
    add_node_argument,
    add_timeout_option,
    found_node,
    print_result,
)

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Delete parameter"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    add_hidden_option(parser, "nodes")
    completed(parser.add_argument("parameter_name", help="Name of the parameter"), completion.parameter_names)
    add_timeout_option(parser)


async def main(session: Session, args: Namespace) -> str | None:
    from rcl_interfaces.msg import Parameter

    if not await found_node(session, args):
        return "Node not found"
    services = await ParameterServices.of(session, args, args.node_name)
    # Setting a parameter to "not set" (the message's default value) undeclares it.
    response = await services.call("SetParameters", parameters=[Parameter(name=args.parameter_name)])
    print_result(session, response.results[0], "Deleted parameter successfully", "Deleting parameter failed")
    return None
