"""`day6-tui launch-plan PACKAGE FILE [NAME:=VALUE…]`: what a launch file would start, without starting it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.language import language_of


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui launch-plan`, and what it takes."""
    parser = command_parser("launch-plan", language)
    texts, add = parser.texts, parser.add_argument
    add("target", metavar="PACKAGE", known=packages, help=texts("cli.launch-plan.target"))
    add("file", metavar="FILE", nargs="?", help=texts("cli.launch-plan.launch_file_of"))
    add("arguments", metavar="NAME:=VALUE", nargs="*", default=[], help=texts("cli.launch-plan.words"))
    add("--json", action="store_true", help=texts("cli.launch-plan.json"))
    return parser


def packages() -> list[str]:
    """Return the names of packages, for Tab."""
    from day6_core.ros.environment import activate

    activate()
    from ament_index_python.packages import get_packages_with_prefixes

    return sorted(get_packages_with_prefixes())


def main(words: list[str]) -> int:
    """`day6-tui launch-plan WORD…`; returns the exit status.

    A launch file is its author's program: it runs in a process of its own, the same as that of `ros2 launch`.
    """
    from day6_core.ros.environment import LAUNCH_PROCESS, activate, as_program

    activate()
    from day6_core.ros.ros2.launch import launch_file, parsed_arguments

    language = language_of(os.environ, words)
    parser = build_parser(language)
    options = parser.parse_args(words)
    env = as_program(dict(os.environ))
    try:
        path, given = launch_file(Path.cwd(), env, options.target, options.file, options.arguments)
        arguments = list(parsed_arguments(given).items())
    except RuntimeError as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 1
    told = {
        "path": path,
        "arguments": arguments,
        "show": "plan",
        "json": options.json,
        "language": language,
        "guarded": sys.stdout.isatty(),
        "terminals": (),
    }
    return subprocess.run(
        [sys.executable, str(LAUNCH_PROCESS), "launch", json.dumps(told)], env=env, check=False
    ).returncode
