"""Reads short and long options as coreutils do, with their error texts."""

from __future__ import annotations

from collections.abc import Mapping

from day6_core.reason import reason as reason
from day6_core.session.session import Session
from day6_core.shell.language.interpreter import shell_of


class UsageError(Exception):
    """Wrong options; the text is complete but for the name of the command."""


def parse(
    argv: list[str],
    flags: str = "",
    values: str = "",
    long: Mapping[str, str] | None = None,
    joined: str = "",
    *,
    dash_number: bool = False,
) -> tuple[dict[str, str], list[str]]:
    """Return (options, operands) of a command line; `argv[0]` is the command's name.

    `flags` are letters without, `values` letters with a value; `long` maps '--name' to one of those letters. A flag given n times
    has the value of n letters, so that `'r' in options` and `len(options['v'])` both work. Of a value given more than once the
    last one counts, but those of the letters in `joined` are kept, one a line. With `dash_number`, `-3` means `-n 3`.
    Raises UsageError.
    """
    options: dict[str, str] = {}

    def take(letter: str, value: str) -> None:
        options[letter] = f"{options[letter]}\n{value}" if letter in joined and letter in options else value

    operands: list[str] = []
    waiting = list(argv[1:])
    try_help = f"Try '{argv[0]} --help' for more information."
    while waiting:
        argument = waiting.pop(0)
        if argument == "--":
            operands.extend(waiting)
            break
        if argument.startswith("--"):
            name, equals, value = argument.partition("=")
            letter = (long or {}).get(name)
            if letter is None:
                raise UsageError(f"unrecognized option '{argument}'\n{try_help}")
            if letter in values:
                if not equals and not waiting:
                    raise UsageError(f"option '{name}' requires an argument\n{try_help}")
                take(letter, value if equals else waiting.pop(0))
            else:
                options[letter] = options.get(letter, "") + letter
        elif argument.startswith("-") and len(argument) > 1:
            rest = argument[1:]
            if dash_number and rest.isdigit():
                options["n"] = rest
                continue
            while rest:
                letter, rest = rest[0], rest[1:]
                if letter in values:
                    if not rest and not waiting:
                        raise UsageError(f"option requires an argument -- '{letter}'\n{try_help}")
                    take(letter, rest or waiting.pop(0))
                    break
                if letter not in flags:
                    raise UsageError(f"invalid option -- '{letter}'\n{try_help}")
                options[letter] = options.get(letter, "") + letter
        else:
            operands.append(argument)
    return options, operands


def complain(session: Session, text: object) -> None:
    """Print `name: text` to standard error."""
    session.print_error(f"{session.name}: {text}")


def complain_as_shell(session: Session, text: object) -> None:
    """Print `bash: name: text` to standard error, as built-ins of the shell do."""
    session.print_error(f"{shell_of(session).name}: {session.name}: {text}")
