"""`ros2 param dump`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_tui.core.ros.ros2.cli.node import absolute
from day6_tui.core.ros.ros2.cli.options import add_hidden_option
from day6_tui.core.ros.ros2.param._services import (
    ParameterServices,
    add_node_argument,
    add_timeout_option,
    found_node,
)
from day6_tui.core.ros.ros2.param._values import python_value

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

SUMMARY = "Show all of the parameters of a node in a YAML file format"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    add_hidden_option(parser, "nodes")
    add_timeout_option(parser)


async def main(session: Session, args: Namespace) -> str | None:
    import yaml

    name = absolute(args.node_name)
    if not await found_node(session, args):
        return "Node not found"
    services = await ParameterServices.of(session, args, name)
    if not await services.ready():
        session.print_error(f"Wait for service timed out waiting for parameter services for node {name}")
        return None
    try:
        names = sorted((await services.call("ListParameters")).result.names)
        response = await services.call("GetParameters", names=names)
    except RuntimeError as error:
        session.print_error(f"Exception while calling get_parameters service of node '{name}': {error}")
        return None
    tree: dict[str, Any] = {}
    for parameter, value in zip(names, response.values, strict=False):
        _insert(tree, parameter, python_value(value))
    session.print(yaml.safe_dump({name: {"ros__parameters": tree}}, default_flow_style=False))
    return None


def _insert(tree: dict[str, Any], name: str, value: Any) -> None:
    """Insert the value of `a.b.c` into nested dicts."""
    first, dot, rest = name.partition(".")
    if dot:
        _insert(tree.setdefault(first, {}), rest, value)
    else:
        tree[name] = value
