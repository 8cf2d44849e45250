"""`ros2 extensions`: the commands and verbs by the groups in which the real ones are registered."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "List extensions"


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--all",
        "-a",
        action="store_true",
        help="Also show extensions which failed to load or are incompatible. (prefixed with `- `)",
    )
    parser.add_argument("--verbose", "-v", action="store_true", help="Show more information for each extension")


def groups() -> dict[str, list[tuple[str, str, str]]]:
    """Return the groups, sorted, each with `(name, summary, module)` of its commands or verbs."""
    from day6_core.ros.ros2.cli.tree import ROOT, command_names, summary, verb_names

    found = {"ros2cli.command": [(name, summary(name), f"{ROOT}.{name}") for name in command_names()]}
    for command in command_names():
        verbs = [(verb, summary(command, verb), f"{ROOT}.{command}.{verb}") for verb in verb_names(command)]
        if verbs and command != "wtf":
            found[group_name(command)] = verbs
    return dict(sorted(found.items()))


def group_name(command: str) -> str:
    """Return the group of a command's verbs; the packages are named after their commands, with two exceptions."""
    return {"daemon": "ros2cli.daemon.verb", "security": "sros2.verb"}.get(command, f"ros2{command}.verb")


async def main(session: Session, args: Namespace) -> None:
    for group, rows in groups().items():
        session.print(group)
        for name, summary, module in rows:
            session.print(f"  {name}: {summary}")
            if args.verbose:
                session.print("     module_name:", module)
