"""`ros2 param dump`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.node import absolute
from day6_core.ros.ros2.cli.options import add_hidden_option
from day6_core.ros.ros2.param._services import (
    ParameterServices,
    add_node_argument,
    add_timeout_option,
    found_node,
)
from day6_core.ros.ros2.param._values import python_value

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Show all of the parameters of a node in a YAML file format"


def add_arguments(parser: ArgumentParser) -> None:
    add_node_argument(parser)
    add_hidden_option(parser, "nodes")
    add_timeout_option(parser)
    if value("param.dump_to_folder"):
        parser.add_argument(
            "--output-dir", default=".", help="DEPRECATED: The absolute path where to save the generated file"
        )
        parser.add_argument("--print", action="store_true", help="DEPRECATED: Does nothing.")


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
    for parameter, each in zip(names, response.values, strict=False):
        _insert(tree, parameter, python_value(each))
    text = yaml.safe_dump({name: {"ros__parameters": tree}}, default_flow_style=False)
    if value("param.dump_to_folder") and not _is_printed(session, args):
        return _save(session, Path(args.output_dir, f"{name[1:].replace('/', '__')}.yaml"), text)
    session.print(text)
    return None


def _is_printed(session: Session, args: Namespace) -> bool:
    if args.print:
        session.print_error("WARNING: '--print' is deprecated; this utility prints to stdout by default")
    if args.output_dir != ".":
        session.print_error("WARNING: '--output-dir' is deprecated; use redirection to save to a file")
    return bool(args.output_dir == ".")


def _save(session: Session, file: Path, text: str) -> str | None:
    """Write a node's parameters as Humble does, and never over another file; return what is wrong."""
    path = Path(session.cwd, file)
    if not path.parent.is_dir():
        return f"'{file.parent}' is not a valid directory."
    session.print("Saving to: ", file)
    try:
        with open(path, "x", encoding="utf-8") as stream:
            stream.write(text)
    except OSError as error:
        return f"{error.strerror}: '{file}'"
    return None


def _insert(tree: dict[str, Any], name: str, value: Any) -> None:
    """Insert the value of `a.b.c` into nested dicts."""
    first, dot, rest = name.partition(".")
    if dot:
        _insert(tree.setdefault(first, {}), rest, value)
    else:
        tree[name] = value
