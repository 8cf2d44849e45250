"""`ros2 param get`."""

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
)
from day6_tui.core.ros.ros2.param._values import NOT_SET, is_known, label, python_value

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

SUMMARY = "Get parameter"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    add_hidden_option(parser, "nodes")
    completed(parser.add_argument("parameter_name", help="Name of the parameter"), completion.parameter_names)
    parser.add_argument("--hide-type", action="store_true", help="Hide the type information")
    add_timeout_option(parser)


async def main(session: Session, args: Namespace) -> str | None:
    if not await found_node(session, args):
        return "Node not found"
    services = await ParameterServices.of(session, args, args.node_name)
    response = await services.call("GetParameters", names=[args.parameter_name])
    if not response.values:
        return "Parameter not set"
    value = response.values[0]
    if value.type == NOT_SET:
        session.print("None" if args.hide_type else "Parameter not set.")
    elif not is_known(value.type):
        return f"Unknown parameter type '{value.type}'"
    elif args.hide_type:
        session.print(python_value(value))
    else:
        session.print(label(value.type), python_value(value))
    return None
