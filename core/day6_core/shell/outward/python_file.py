"""`day6-tui python FILE …`: a Python file as a ROS program."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.command_line.parser import CommandParser


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui python`; what follows them is python3's."""
    from day6_core.command_line.parser import command_parser

    parser = command_parser("python", language)
    parser.add_argument("--fast", action="store_true", help=parser.texts("cli.fast"))
    parser.add_argument("file", nargs="?", metavar="FILE", help=parser.texts("cli.python.file"))
    parser.add_argument("arguments", nargs="*", metavar="ARG", help=parser.texts("cli.python.arguments"))
    return parser


def main(words: list[str]) -> int:
    """Become `python3 FILE ARG…` with our packages on its path; returns its exit status where that cannot be."""
    from day6_core.ros.environment import program_environment

    fast = False
    if words and words[0].startswith("-"):
        fast, words = _obeyed(words)
    argv = [sys.executable, *words]
    environment = program_environment()
    if fast:
        from day6_core.language import language_of
        from day6_core.shell.outward.fast import begin_anew_or_say

        return begin_anew_or_say(build_parser(language_of(os.environ)), argv, environment)
    if sys.platform != "win32":
        os.execve(sys.executable, argv, environment)
    from day6_core.shell.outward.subshell import call

    return call(argv, environment)


def _obeyed(words: list[str]) -> tuple[bool, list[str]]:
    """Obey the options of `day6-tui python` itself; return whether one is --fast, and the words for python3."""
    from day6_core.command_line.leading import BEFORE_A_PROGRAM, leading
    from day6_core.language import VARIABLE, language_of

    options, words = leading(words, (*BEFORE_A_PROGRAM, "--fast"))
    if not options:
        return False, words
    os.environ[VARIABLE] = language = language_of(os.environ, options)
    return build_parser(language).parse_args(options).fast, words
