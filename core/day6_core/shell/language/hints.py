"""What is written in grey below the message of a command that failed in a terminal: a hint, or the first line of its card."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Protocol, runtime_checkable

from day6_core.session.streams import InputStream
from day6_core.session.threads import in_thread
from day6_core.shell.language.shell_state import NOT_FOUND

if TYPE_CHECKING:
    from day6_core.shell.desk import Desk
    from day6_core.shell.language.interpreter import Shell

BY_SIGNAL = 128
"""A larger status is that of a command which a signal has ended."""


class Printed:
    """What a command prints to its terminal from now on."""

    def __init__(self, stdin: InputStream) -> None:
        from day6_core.shell.terminal import Terminal

        terminal = stdin.terminal_of()
        self._run = terminal.runs.running if isinstance(terminal, Terminal) else None
        self._before = self._run.written if self._run is not None else 0

    @property
    def line(self) -> str:
        """What was typed; '' where there is no terminal."""
        return self._run.source if self._run is not None else ""

    def text(self) -> str:
        """Return the end of it; '' where there is no terminal."""
        if self._run is None or self._run.written == self._before:
            return ""
        return self._run.output[-(self._run.written - self._before) :]


async def hint_below_command(shell: Shell, argv: list[str], printed: Printed, status: int) -> str:
    """Return the line, with its end, for a command that failed, '' for none.

    A hint needs one of its words to show what is wrong for certain.
    """
    if shell.desk.searching():
        return ""
    from day6_core.advice.below import first_line_below, wants_first_lines
    from day6_core.advice.rules import Surroundings, dimmed, hint_about_command
    from day6_core.shell.commands import command_names

    around = Surroundings(shell.variables, shell.cwd)
    missing = status == NOT_FOUND and argv[0] not in shell.functions
    commands = command_names() if missing else ()
    odd = any(word.startswith("/home/") or not word.isascii() for word in argv)
    typed, letters = one_of(printed.line, argv[0]), letters_awaited(shell.desk) if missing else ""
    if missing or odd or argv[0] in ("ros2", "colcon"):
        output = printed.text() if argv[0] in ("ros2", "colcon") else ""
        hint = hint_about_command(argv, around, commands, line=typed, letters=letters, output=output)
        if hint:
            return f"{dimmed(hint)}\n"
    if status > BY_SIGNAL or not wants_first_lines(around) or not (output := printed.text()):
        return ""
    line = await in_thread(lambda: first_line_below(output, around, command=typed, commands=commands, letters=letters))
    return f"{dimmed(line)}\n" if line else ""


def one_of(source: str, name: str) -> str:
    """Return the one command of a line that `name` begins, the whole line where it begins none."""
    from day6_core.advice.explain import simple_command

    return simple_command(source, {"name": name})


def hint_at_open_quote(shell: Shell, problem: str) -> str:
    """Return the line, with its end, for somebody who types on at `> ` and may not know why; `problem` says what is open."""
    from day6_core.advice.rules import Surroundings, dimmed, hint_about_quote

    quote = _OPEN_QUOTE.search(problem)
    hint = hint_about_quote(quote[1], Surroundings(shell.variables, shell.cwd)) if quote is not None else ""
    return f"{dimmed(hint)}\n" if hint else ""


def hint_at_syntax(shell: Shell, source: str) -> str:
    """Return the line, with its end, for somebody whose one line could not be read; '' where nothing is certain."""
    from day6_core.advice.rules import Surroundings, dimmed, hint_about_syntax

    if shell.desk.searching() or "\n" in source.strip():
        return ""
    hint = hint_about_syntax(source.strip(), Surroundings(shell.variables, shell.cwd))
    return f"{dimmed(hint)}\n" if hint else ""


_OPEN_QUOTE = re.compile(r"looking for matching `(['\"`])'")


@runtime_checkable
class AsksByLetter(Protocol):
    """A window that waits for the answer to a question."""

    @property
    def letters_awaited(self) -> str:
        """The letters that are answers, '' while nothing is asked."""


def letters_awaited(desk: Desk) -> str:
    """Return the answers that an open question waits for: 'abc'; '' for none."""
    models = [window.model for window in desk.display.windows] if desk.display is not None else []
    return "".join(model.letters_awaited for model in models if isinstance(model, AsksByLetter))
