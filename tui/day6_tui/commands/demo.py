"""`day6-tui demo DAY`: the desktop with a lesson that is played by itself."""

from __future__ import annotations

import os

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.language import language_of
from day6_tui.commands import desktop


def build_parser(language: str = "en") -> CommandParser:
    """What it takes, and the options of the desktop."""
    parser = command_parser("demo", language)
    parser.used_as("[OPTION ...] DAY")
    parser.add_argument(
        "lesson", type=_name, metavar="DAY", known=desktop.lesson_names, help=parser.texts("cli.demo.day")
    )
    desktop.add_options(parser, lesson=False)
    parser.set_defaults(demo=True)
    return parser


def main(words: list[str]) -> int:
    """`day6-tui demo DAY [OPTION …]`; returns the exit status."""
    parser = build_parser(language_of(os.environ, words))
    return desktop.begin(parser, parser.parse_args(words), ["demo", *words])


def _name(text: str) -> str:
    return f"day{text}" if text.isdecimal() else text
