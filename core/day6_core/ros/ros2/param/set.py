"""`ros2 param set`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli import completion
from day6_core.ros.ros2.cli.options import add_hidden_option, completed
from day6_core.ros.ros2.param._services import (
    ParameterServices,
    add_node_argument,
    add_timeout_option,
    found_node,
    print_result,
)
from day6_core.ros.ros2.param._values import value_from_text

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Set parameter"
_PAIRS = "Parameters must be provided as name/value pairs: name value [name value ...]. Got {} argument(s)."


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    add_hidden_option(parser, "nodes")
    if value("param.several"):
        completed(
            parser.add_argument(
                "params_and_values",
                nargs="+",
                metavar="name value",
                help="Name and value of one parameter or more: name value [name value ...]",
            ),
            completion.parameter_names,
        )
        parser.add_argument("--atomic", action="store_true", help="Change all of the parameters, or none of them")
    else:
        completed(parser.add_argument("parameter_name", help="Name of the parameter"), completion.parameter_names)
        parser.add_argument("value", help="Value of the parameter")
    add_timeout_option(parser)


async def main(session: Session, args: Namespace) -> str | None:
    from rcl_interfaces.msg import Parameter

    words = args.params_and_values if value("param.several") else [args.parameter_name, args.value]
    if len(words) % 2:
        return _PAIRS.format(len(words))
    if not await found_node(session, args):
        return "Node not found"
    parameters = [
        Parameter(name=name, value=value_from_text(text)) for name, text in zip(words[::2], words[1::2], strict=True)
    ]
    services = await ParameterServices.of(session, args, args.node_name)
    if value("param.several") and args.atomic:
        response = await services.call("SetParametersAtomically", parameters=parameters)
        print_result(
            session, response.result, "Set parameters atomically successful", "Setting parameters atomically failed"
        )
        return None
    response = await services.call("SetParameters", parameters=parameters)
    for parameter, result in zip(parameters, response.results, strict=True):
        about = f"{parameter.name}: " if len(parameters) > 1 else ""
        print_result(session, result, f"{about}Set parameter successful", f"{about}Setting parameter failed")
    return None
