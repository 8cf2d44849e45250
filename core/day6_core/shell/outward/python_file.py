"""`day6-tui python FILE …`: a Python file as a ROS program."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from day6_core.command_line.leading import BEFORE_A_PROGRAM, leading

if TYPE_CHECKING:
    from day6_core.command_line.parser import CommandParser


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui python`; what follows them is python3's."""
    from day6_core.command_line.parser import command_parser

    parser = command_parser("python", language)
    parser.add_argument("file", nargs="?", metavar="FILE", help=parser.texts("cli.python.file"))
    parser.add_argument("arguments", nargs="*", metavar="ARG", help=parser.texts("cli.python.arguments"))
    return parser


def main(words: list[str]) -> int:
    """Become `python3 FILE ARG…` with our packages on its path; returns its exit status where that cannot be."""
    from day6_core.language import VARIABLE, language_of
    from day6_core.ros.environment import program_environment

    options, words = leading(words, BEFORE_A_PROGRAM)
    if options:
        os.environ[VARIABLE] = language = language_of(os.environ, options)
        build_parser(language).parse_args(options)
    argv = [sys.executable, *words]
    environment = program_environment()
    if sys.platform != "win32":
        os.execve(sys.executable, argv, environment)
    from day6_core.shell.outward.subshell import call

    return call(argv, environment)
