"""`day6-tui completion SHELL`: prints the script that makes Tab complete `day6-tui` in a shell."""

from __future__ import annotations

import os

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.language import language_of
from day6_core.shell.outward.real_completion import SHELLS, functions


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui completion`, and what it takes."""
    parser = command_parser("completion", language)
    parser.add_argument("shell", choices=SHELLS, metavar="SHELL", help=parser.texts("cli.completion.shell"))
    parser.epilog = parser.texts("cli.completion.more")
    return parser


def main(words: list[str]) -> int:
    """`day6-tui completion SHELL`; returns the exit status."""
    options = build_parser(language_of(os.environ, words)).parse_args(words)
    print(functions(options.shell, ["day6-tui"], ["day6-tui"]), end="")
    return 0
