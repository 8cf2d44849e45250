"""`day6-tui env`: the variables that make a terminal of the user one of ours, or the settings of an editor."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from pathlib import Path

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.language import language_of
from day6_core.ros.environment import program_environment
from day6_core.session.folder import working_folder


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui env`."""
    parser = command_parser("env", language)
    texts = parser.texts
    parser.add_argument("--vscode", action="store_true", help=texts("cli.env.vscode"))
    parser.add_argument("--pycharm", action="store_true", help=texts("cli.env.pycharm"))
    parser.add_argument(
        "project", nargs="?", type=Path, default=Path(), metavar="FOLDER", help=texts("cli.env.project")
    )
    return parser


def main(arguments: list[str]) -> int:
    """Print what `eval "$(day6-tui env)"` needs, or write the settings of an editor; returns the exit status."""
    parser = build_parser(language_of(os.environ, arguments))
    options = parser.parse_args(arguments)
    if options.vscode or options.pycharm:
        return _write_settings(parser, options)
    before = dict(os.environ)
    for name, value in program_environment().items():
        if before.get(name) != value:
            print(f"set {name}={value}" if os.name == "nt" else f"export {name}={shlex.quote(value)}")
    return 0


def _write_settings(parser: CommandParser, options: argparse.Namespace) -> int:
    from day6_core.ros.environment import activate
    from day6_core.shell.outward import ide

    activate()
    project, stubs = working_folder() / options.project, ide.stub_folder()
    if not project.is_dir():
        parser.refuse("FOLDER", parser.texts("cli.wrong.folder", text=project))
    try:
        count = ide.write_stubs(stubs)
        files = ide.write_vscode(project, stubs) if options.vscode else []
        files += ide.write_pycharm(project, stubs) if options.pycharm else []
    except (OSError, ide.NotUnderstood) as error:
        reason = f"{error.filename}: {error.strerror}" if isinstance(error, OSError) else error.said(parser.texts)
        print(f"{parser.prog}: {reason}", file=sys.stderr)
        return 1
    print(parser.texts("cli.env.stubs", count=count, folder=stubs))
    for file in files:
        print(parser.texts("cli.env.wrote", file=file))
    return 0
