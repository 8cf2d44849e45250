"""`set -x`: what is printed before a command runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.shell.language.lexer import single_word
from day6_core.shell.language.quoting import traced
from day6_core.shell.language.syntax import Assignment
from day6_core.shell.language.words import ArrayLiteral

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams


async def trace(shell: Shell, streams: Streams, text: str) -> None:
    """Print a command, as it is about to run, after PS4, whose first character is repeated for each `$( )` around it."""
    if "x" not in shell.options:
        return
    from day6_core.shell.language.expansion import expand_text

    shell.options.discard("x")
    try:
        prefix = await expand_text(single_word(shell.variables.get("PS4", "+ "), quoted=True), shell, streams)
    finally:
        shell.options.add("x")
    streams.stderr.write(f"{prefix[:1] * shell.substitutions}{prefix}{text}\n")


def words(argv: list[str]) -> str:
    """The words of a command, quoted where they need it."""
    return " ".join(traced(word) for word in argv)


def assigned(made: Assignment, value: object) -> str:
    """An assignment: an array as it is written, a text as it became."""
    subscript = "" if made.subscript is None else f"[{made.subscript}]"
    shown = traced(value) if isinstance(value, str) and value else ""
    if isinstance(made.value, ArrayLiteral):
        shown = f"({' '.join(word.source for word in made.value.elements)})"
    return f"{made.name}{subscript}{'+' * made.append}={shown}"
