"""`ros2 interface show`: the text of a definition, with the definitions of the fields' types indented below the fields."""

from __future__ import annotations

import re
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.choice import choose, may_be_left_out
from day6_core.ros.ros2.cli.completion import interface_types
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Output the interface definition"

_PRIMITIVE = re.compile(r"(bool|byte|char|float32|float64|u?int(8|16|32|64)|w?string)\b")


def add_arguments(parser: ArgumentParser) -> None:
    comments = parser.add_mutually_exclusive_group()
    comments.add_argument(
        "--all-comments",
        action="store_true",
        help="Show all comments, including for nested interface definitions",
    )
    comments.add_argument("--no-comments", action="store_true", help="Show no comments or whitespace")
    completed(
        parser.add_argument(
            "type",
            nargs=may_be_left_out(),
            help="Show an interface definition (e.g. 'example_interfaces/msg/String'). Passing '-' reads the argument from "
            "stdin (e.g. 'ros2 topic type /chatter | ros2 interface show -').",
        ),
        interface_types,
    )
    parser.set_defaults(parser=parser)


async def main(session: Session, args: Namespace) -> str | None:
    name = args.type
    if name is None:
        from day6_core.ros.ros2.interface.list import interface_names

        name = await choose(session, interface_names(session.env), "Select interface:")
    if name == "-":
        if session.stdin.isatty():
            args.parser.error("expected stdin pipe")
        name = (await session.stdin.read_line()).strip()
    if not name:
        args.parser.error("the passed value is empty")
    try:
        for line in definition_lines(
            name, session.env, comments=not args.no_comments, nested_comments=args.all_comments
        ):
            session.print(line)
    except (ValueError, LookupError) as error:
        return str(error)
    return None


def definition_lines(
    name: str, environment: Mapping[str, str], *, comments: bool, nested_comments: bool, indent: str = ""
) -> Iterator[str]:
    """Yield the lines of a definition and of everything in it. Raises ValueError or LookupError for a wrong name."""
    from rosidl_runtime_py.get_interfaces import get_interface_path

    parts = name.split("/")
    if len(parts) != 3:
        raise ValueError(f"Invalid name '{name}'. Expected three parts separated by '/'")
    for line in Path(get_interface_path(name, environment)).read_text(encoding="utf-8").splitlines():
        text = line.rstrip()
        shown: str | None = text if comments else _without_comment(text)
        if shown is not None:
            yield f"{indent}{shown}" if shown else ""
        nested = _nested_type(text, parts[0])
        if nested is not None:
            yield from definition_lines(
                nested, environment, comments=nested_comments, nested_comments=nested_comments, indent=f"{indent}\t"
            )


def _nested_type(line: str, package: str) -> str | None:
    """Return the full name of a field's message type, None for any other line."""
    words = line.partition("#")[0].split()
    if len(words) < 2 or _PRIMITIVE.match(words[0]) or words[0] == "---":
        return None
    owner, slash, kind = words[0].partition("[")[0].rpartition("/")
    return f"{owner if slash else package}/msg/{kind}"


def _without_comment(line: str) -> str | None:
    """Return a line without its comment, None if nothing is left."""
    return line.partition("#")[0].rstrip() or None
