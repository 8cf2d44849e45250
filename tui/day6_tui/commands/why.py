"""`day6-tui why`: explains a message: the words, or the last line with a card of what is piped in."""

from __future__ import annotations

import os

from day6_core.command_line.leading import BEFORE_A_PROGRAM, leading
from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.language import VARIABLE, language_of


def build_parser(language: str = "en") -> CommandParser:
    """Its options, and what it takes."""
    parser = command_parser("why", language)
    parser.add_argument("text", nargs="*", metavar="TEXT", help=parser.texts("cli.why.text"))
    return parser


def main(words: list[str]) -> int:
    """`day6-tui why [TEXT …]`; returns the exit status."""
    from day6_core.session.local import run_local
    from day6_core.shell.builtins.why import why

    options, words = leading(words, BEFORE_A_PROGRAM)
    if options:
        os.environ[VARIABLE] = language = language_of(os.environ, options)
        build_parser(language).parse_args(options)
    return run_local(why, ["why", *words], one_shot=True)
