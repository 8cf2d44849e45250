"""`day6-tui complete SHELL LINE`: what Tab offers; the scripts of `day6-tui completion` call it."""

from __future__ import annotations

import argparse
import os

from day6_core.command_line.leading import DISTRIBUTION, LANGUAGE, leading
from day6_core.command_line.parser import CommandParser
from day6_core.command_line.texts import CommandTexts
from day6_core.language import language_of
from day6_core.shell.outward.real_completion import SHELLS, complete
from day6_tui.commands.table import command_named, names

_REPEATED = ("*", "+", argparse.REMAINDER)


def main(words: list[str]) -> int:
    """Print the answers, one a line; return the exit status."""
    parser = CommandParser("day6-tui complete", texts=CommandTexts(language_of(os.environ, words)))
    parser.add_argument("shell", choices=SHELLS)
    parser.add_argument("line", metavar="LINE")
    options = parser.parse_args(words)
    return complete(options.shell, options.line, own_words)


def own_words(words: list[str]) -> list[str]:
    """What may stand in place of the last of the words after `day6-tui`; nothing where a file is expected."""
    *before, typed = words
    _, rest = leading(before, (LANGUAGE, DISTRIBUTION))
    if rest and (command := command_named(rest[0])) is not None:
        parser = command.parser("en")
        return [] if parser is None else words_of(parser, rest[1:], typed)
    from day6_tui.commands.desktop import build_parser

    offered = words_of(build_parser(), before, typed)
    if rest or offered or typed.startswith("-") or before[-1:] in ([LANGUAGE], [DISTRIBUTION]):
        return offered
    return names()


def words_of(parser: CommandParser, before: list[str], typed: str) -> list[str]:
    """What may stand in place of `typed` behind the words of a command."""
    options = {option: action for action in parser.actions for option in action.option_strings}
    arguments = [action for action in parser.actions if not action.option_strings]
    values, wanting = 0, None
    for at, word in enumerate(before):
        if values:
            values -= 1
        elif word.startswith("-") and len(word) > 1:
            wanting = options.get(word)
            values = _values_of(wanting)
        elif arguments:
            if word in parser.verbs:
                return words_of(parser.verbs[word], before[at + 1 :], typed)
            if arguments[0].nargs not in _REPEATED:
                del arguments[0]
    if values and wanting is not None:
        return _known(parser, wanting)
    option, equals, _ = typed.partition("=")
    if equals and option in options:
        return [f"{option}={value}" for value in _known(parser, options[option])]
    if typed.startswith("-"):
        return list(options)
    return _known(parser, arguments[0]) if arguments else []


def _values_of(action: argparse.Action | None) -> int:
    """How many words after an option are its value."""
    if action is None:
        return 0
    return action.nargs if isinstance(action.nargs, int) else 1


def _known(parser: CommandParser, action: argparse.Action) -> list[str]:
    """The values that an option or argument is known to take."""
    if action.choices is not None:
        return [str(choice) for choice in action.choices]
    return list(parser.known.get(action.dest, list)())
