"""`day6-tui help [COMMAND]`: the same as `day6-tui COMMAND --help`."""

from __future__ import annotations

import os

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.language import language_of
from day6_tui.commands.table import names


def build_parser(language: str = "en") -> CommandParser:
    """Its options, and what it takes."""
    parser = command_parser("help", language)
    parser.add_argument("command", nargs="*", metavar="COMMAND", known=names, help=parser.texts("cli.help.command"))
    return parser


def main(words: list[str]) -> int:
    """`day6-tui help [COMMAND …]`; returns the exit status."""
    from day6_tui.main import main as day6_tui

    options = build_parser(language_of(os.environ, words)).parse_args(words)
    chosen = [] if options.lang is None else ["--lang", options.lang]
    return day6_tui([*chosen, *options.command, "--help"])
