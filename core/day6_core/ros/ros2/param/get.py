"""`ros2 param get`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli import completion
from day6_core.ros.ros2.cli.choice import NothingChosen, choose, choose_node
from day6_core.ros.ros2.cli.node import graph_node, node_names
from day6_core.ros.ros2.cli.options import add_hidden_option, completed
from day6_core.ros.ros2.param._services import (
    ParameterServices,
    add_node_argument,
    add_timeout_option,
    found_node,
)
from day6_core.ros.ros2.param._values import NOT_SET, is_known, label, shown_value

if TYPE_CHECKING:
    from rcl_interfaces.msg import ParameterValue

    from day6_core.session.session import Session

SUMMARY = "Get parameter"


def add_arguments(parser: ArgumentParser) -> None:
    several = value("param.several")
    add_node_argument(parser, optional=several)
    add_hidden_option(parser, "nodes")
    words = "Name of the parameter(s); without a node's name, one that all nodes are asked for"
    completed(
        parser.add_argument("parameter_name", nargs="*", help=words)
        if several
        else parser.add_argument("parameter_name", help="Name of the parameter"),
        completion.parameter_names,
    )
    parser.add_argument("--hide-type", action="store_true", help="Hide the type information")
    add_timeout_option(parser)


async def main(session: Session, args: Namespace) -> str | None:
    if value("param.several"):
        return await _several(session, args)
    if not await found_node(session, args):
        return "Node not found"
    services = await ParameterServices.of(session, args, args.node_name)
    response = await services.call("GetParameters", names=[args.parameter_name])
    if not response.values:
        return "Parameter not set"
    found = response.values[0]
    if not _is_known(found):
        return f"Unknown parameter type '{found.type}'"
    session.print(_text(found, args))
    return None


async def _several(session: Session, args: Namespace) -> str | None:
    """Get several parameters of a node, or one of all nodes: a single word is its name."""
    if args.node_name is None and (refusal := await _choose(session, args)) is not None:
        return refusal
    names: list[str] = args.parameter_name or [args.node_name]
    everywhere = not args.parameter_name
    if everywhere:
        async with graph_node(session, args) as node:
            nodes = sorted(set(node_names(node, hidden=args.include_hidden_nodes)))
        if not nodes:
            return "No nodes found"
    elif await found_node(session, args):
        nodes = [args.node_name]
    else:
        return "Node not found"
    services = await ParameterServices.of(session, args, "")
    found = False
    for name in nodes:
        try:
            response = await services.for_node(name).call("GetParameters", names=names)
        except RuntimeError as error:
            if not everywhere:
                raise
            session.print_error(f"{name}: Error: {error}")
            continue
        if not response.values and not everywhere:
            return f"Parameter(s) {', '.join(map(repr, names))} not available on node"
        for parameter, each in zip(names, response.values, strict=False):
            found = True
            if not _is_known(each):
                unknown = f"Unknown parameter type '{each.type}'"
                session.print_error(f"{name}: {unknown}" if everywhere else f"{unknown} for parameter '{parameter}'")
                continue
            title = name if everywhere else parameter if len(names) > 1 else ""
            between = ": " if args.hide_type else ":\n  "
            session.print(f"{title}{between if title else ''}{_text(each, args)}")
    if not found:
        session.print(f"Parameter '{names[0]}' not set on any node")
    return None


async def _choose(session: Session, args: Namespace) -> str | None:
    """Let the user choose a node and one of its parameters; return what is wrong."""
    async with graph_node(session, args) as node:
        try:
            args.node_name = await choose_node(session, node, "Select node:", hidden=args.include_hidden_nodes)
        except NothingChosen:
            return "No node selected"
    services = await ParameterServices.of(session, args, args.node_name)
    names = (await services.call("ListParameters")).result.names
    session.executor.remove_node(services.node)
    services.node.destroy_node()  # the next one has its name
    if not names:
        return "No parameters available to select from."
    args.parameter_name = [await choose(session, names, "Select parameter:")]
    return None


def _is_known(found: ParameterValue) -> bool:
    return found.type == NOT_SET or is_known(found.type)


def _text(found: ParameterValue, args: Namespace) -> str:
    if args.hide_type:
        return str(shown_value(found))
    return "Parameter not set." if found.type == NOT_SET else f"{label(found.type)} {shown_value(found)}"
