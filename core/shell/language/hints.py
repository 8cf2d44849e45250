"""What is written in grey below the message of a command that failed in a terminal: a hint, or the first line of its card."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.session.streams import InputStream
from day6_tui.core.session.threads import in_thread
from day6_tui.core.shell.language.shell_state import NOT_FOUND

if TYPE_CHECKING:
    from day6_tui.core.shell.language.interpreter import Shell

BY_SIGNAL = 128
"""A larger status is that of a command which a signal has ended."""


class Printed:
    """What a command prints to its terminal from now on."""

    def __init__(self, stdin: InputStream) -> None:
        from day6_tui.core.shell.terminal import Terminal

        terminal = stdin.terminal_of()
        self._run = terminal.runs.running if isinstance(terminal, Terminal) else None
        self._before = self._run.written if self._run is not None else 0

    def text(self) -> str:
        """Return the end of it; '' where there is no terminal."""
        if self._run is None or self._run.written == self._before:
            return ""
        return self._run.output[-(self._run.written - self._before) :]


async def hint_below_command(shell: Shell, argv: list[str], printed: Printed) -> str:
    """Return the line, with its end, for a command that failed, '' for none.

    A hint needs one of its words to show what is wrong for certain.
    """
    from day6_tui.core.advice.rules import (
        Surroundings,
        dimmed,
        first_line_below,
        hint_about_command,
        wants_first_lines,
    )
    from day6_tui.core.shell.commands import command_names

    around = Surroundings(shell.variables, shell.cwd)
    missing = shell.status == NOT_FOUND and "/" not in argv[0] and argv[0] not in shell.functions
    commands = command_names() if missing else ()
    worth_a_look = missing or argv[0] == "ros2" or any(word.startswith("/home/") for word in argv)
    if worth_a_look and (hint := hint_about_command(argv, around, commands)):
        return f"{dimmed(hint)}\n"
    if shell.status > BY_SIGNAL or not wants_first_lines(around) or not (output := printed.text()):
        return ""
    line = await in_thread(lambda: first_line_below(output, around))
    return f"{dimmed(line)}\n" if line else ""
