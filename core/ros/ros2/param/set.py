"""`ros2 param set`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_tui.core.ros.ros2.cli import completion
from day6_tui.core.ros.ros2.cli.options import add_hidden_option, completed
from day6_tui.core.ros.ros2.param._services import (
    ParameterServices,
    add_node_argument,
    add_timeout_option,
    found_node,
    print_result,
)
from day6_tui.core.ros.ros2.param._values import value_from_text

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

SUMMARY = "Set parameter"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    add_hidden_option(parser, "nodes")
    completed(parser.add_argument("parameter_name", help="Name of the parameter"), completion.parameter_names)
    parser.add_argument("value", help="Value of the parameter")
    add_timeout_option(parser)


async def main(session: Session, args: Namespace) -> str | None:
    from rcl_interfaces.msg import Parameter

    if not await found_node(session, args):
        return "Node not found"
    parameter = Parameter(name=args.parameter_name, value=value_from_text(args.value))
    services = await ParameterServices.of(session, args, args.node_name)
    response = await services.call("SetParameters", parameters=[parameter])
    print_result(session, response.results[0], "Set parameter successful", "Setting parameter failed")
    return None
