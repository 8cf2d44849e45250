"""`ros2 param list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.node import absolute, graph_node, node_names, split_name
from day6_core.ros.ros2.cli.options import add_hidden_option, add_response_timeout
from day6_core.ros.ros2.param._services import ParameterServices, add_node_argument
from day6_core.ros.ros2.param._values import type_name
from day6_core.session.harmless import in_a_list
from day6_core.user_pattern import user_pattern

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output a list of available parameters"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser, optional=True)
    parser.add_argument(
        "--filter",
        nargs=1,
        help="Only parameters matching the regex expression will be showed. Supports `re` regex syntax.",
    )
    add_hidden_option(parser, "nodes")
    parser.add_argument(
        "--param-prefixes", nargs="+", default=[], help="Only list parameters with the provided prefixes"
    )
    parser.add_argument("--param-type", action="store_true", help="Print parameter types with parameter names")
    if value("param.several"):
        add_response_timeout(parser, "--service-timeout", 5.0)


async def main(session: Session, args: Namespace) -> str | None:
    async with graph_node(session, args) as node:
        # Before Lyrical sorted by name first and then by namespace.
        by = None if value("param.several") else split_name
        names = sorted(set(node_names(node, hidden=args.include_hidden_nodes)), key=by)
    if args.node_name:
        wanted = absolute(args.node_name)
        if wanted not in names:
            return "Node not found"
        names = [wanted]
    pattern = user_pattern(args.filter[0]) if args.filter is not None else None
    services = await ParameterServices.of(session, args, "")
    for name in names:
        of_node = services.for_node(name)
        if not await of_node.ready():
            session.print(f"Wait for service timed out waiting for parameter services for node {_node_name(name)}")
            continue
        try:
            response = await of_node.call("ListParameters", prefixes=args.param_prefixes)
        except TimeoutError as error:
            session.print(str(error).replace(name, _node_name(name)))
            continue
        parameters = sorted(response.result.names)
        if pattern is not None:
            parameters = [each for each in parameters if pattern.match(each)]
        if not args.node_name and parameters:
            session.print(f"{name}:")
        types = await _types(of_node, parameters) if args.param_type and parameters else {}
        for each in parameters:
            shown = in_a_list(each, session.stdout)
            session.print(f"  {shown} (type: {types[each]})" if args.param_type else f"  {shown}")
    return None


def _node_name(full_name: str) -> str:
    """Return what ros2cli prints for a node where it formats the tuple instead of the full name."""
    name, namespace = split_name(full_name)
    return f"NodeName(name={name!r}, namespace={namespace!r}, full_name={full_name!r})"


async def _types(services: ParameterServices, parameters: list[str]) -> dict[str, str]:
    response = await services.call("DescribeParameters", names=parameters)
    return {descriptor.name: type_name(descriptor.type) for descriptor in response.descriptors}
