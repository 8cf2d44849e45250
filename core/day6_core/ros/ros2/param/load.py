"""`ros2 param load`."""

from __future__ import annotations

import threading
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.node import absolute, split_name
from day6_core.ros.ros2.cli.options import add_hidden_option
from day6_core.ros.ros2.cli.yaml_text import file_text, in_turns_with_others, load
from day6_core.ros.ros2.param._services import (
    ParameterServices,
    add_node_argument,
    add_timeout_option,
    found_node,
    print_result,
)
from day6_core.ros.ros2.param._values import value_of

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Load parameter file for a node"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    add_hidden_option(parser, "nodes")
    parser.add_argument("parameter_file", help="Parameter file")
    parser.add_argument(
        "--no-use-wildcard",
        action="store_true",
        help="Do not load parameters in the '/**' namespace into the node",
    )
    add_timeout_option(parser)


async def main(session: Session, args: Namespace) -> str | None:
    from rcl_interfaces.msg import Parameter

    if not await found_node(session, args):
        return "Node not found"
    name = absolute(args.node_name)
    services = await ParameterServices.of(session, args, name)
    if not await services.ready():
        return f"Wait for service timed out waiting for parameter services for node {name}"
    values = await in_turns_with_others(
        lambda abandoned: parameters_of_file(
            session, args.parameter_file, name, abandoned, wildcard=not args.no_use_wildcard
        )
    )
    parameters = [Parameter(name=each, value=value_of(value)) for each, value in values.items()]
    response = await services.call("SetParameters", parameters=parameters)
    for parameter, result in zip(parameters, response.results, strict=False):
        one = f"Set parameter {parameter.name}"
        print_result(session, result, f"{one} successful", f"{one} failed")
    return None


MOST_PARAMETERS = 100_000
"""A few lines of YAML can expand to any number through aliases."""


def parameters_of_file(
    session: Session, file_name: str, node_name: str, abandoned: threading.Event, *, wildcard: bool
) -> dict[str, Any]:
    """Return `{name: value}` of a node's parameters in a parameter file; the node's own section overrides `/**`.

    Raises OSError, yaml.YAMLError, KeyError for a section without `ros__parameters`, RuntimeError without parameters.
    """
    content = load(file_text(session, file_name), abandoned)
    name, namespace = split_name(node_name)
    found: dict[str, Any] = {}
    for section in _sections(content, node_name, name, namespace.rstrip("/"), wildcard):
        found.update(section["ros__parameters"])
    if not found:
        raise RuntimeError("Param file does not contain any valid parameters")
    return _flat("", found)


def _sections(content: Any, full_name: str, name: str, namespace: str, wildcard: bool) -> list[Any]:
    known = content.keys()  # AttributeError for a file that isn't a mapping, as in the real command
    sections = [content["/**"]] if wildcard and "/**" in known else []
    if full_name in known:
        sections.append(content[full_name])
    if not namespace and name in known:
        sections.append(content[name])
    elif namespace in known and name in content[namespace]:
        sections.append(content[namespace][name])
    return sections


def _flat(prefix: str, tree: dict[str, Any]) -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for key, value in tree.items():
        name = f"{prefix}.{key}" if prefix else str(key)
        if len(flat) > MOST_PARAMETERS:
            raise RuntimeError("Param file contains too many parameters")
        flat.update(_flat(name, value) if isinstance(value, dict) else {name: value})
    return flat
