"""Simple commands: their words expanded, their redirections opened, their assignments made, and the program found."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from day6_core.session.session import Main, Session
from day6_core.shell.language import syntax, tracing
from day6_core.shell.language.assignments import assign, value_of
from day6_core.shell.language.expansion import expand_command
from day6_core.shell.language.redirection import Streams, redirect
from day6_core.shell.language.refusals import check_words
from day6_core.shell.language.variables import Cell

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell


@dataclass
class Prepared:
    """A command that is ready to run."""

    argv: list[str]
    main: Main
    streams: Streams
    env: dict[str, str]
    opened: ExitStack
    hidden: dict[str, Cell | None] = field(default_factory=dict)
    """Variables as they were before the assignments in front of the command, which last as long as it runs."""

    def finish(self, shell: Shell) -> None:
        """After it ended: close its files, and give variables their values back."""
        self.opened.close()
        restore(shell, self.hidden)


def restore(shell: Shell, hidden: dict[str, Cell | None]) -> None:
    """Give variables the values back that were hidden."""
    for name, cell in hidden.items():
        if cell is None:
            shell.variables.cells.pop(name, None)
        else:
            shell.variables.cells[name] = cell
    hidden.clear()


async def prepare(shell: Shell, command: syntax.SimpleCommand, streams: Streams) -> Prepared | None:
    """Prepare a command; None, with a message, if a redirection failed. Raises SyntaxProblem."""
    from day6_core.shell.commands import SHELL_BUILTINS, find_command, list_too_long, too_long

    shell.substitution_status = 0
    argv = await expand_command(command.words, shell, streams)
    shell.command_now = command
    if argv and argv[0] not in shell.functions:
        check_words(argv[0], list(argv[1:]))
    opened = ExitStack()
    hidden: dict[str, Cell | None] = {}
    try:
        redirected = await redirect(command.redirections, shell, streams, opened)
        await _assign_all(shell, command.assignments, streams, hidden if argv else None)
        if argv:
            await tracing.trace(shell, streams, tracing.words(argv))
    except OSError as error:
        opened.close()
        streams.stderr.write(f"{shell.name}: {error.filename}: {error.strerror}\n")
        return None
    except BaseException:
        opened.close()
        restore(shell, hidden)
        raise
    for file in shell.made_files:
        opened.callback(file.unlink, missing_ok=True)
    shell.made_files.clear()
    if not argv:
        shell.status = shell.substitution_status
    env = shell.environment
    main = find_command(argv[0], shell) if argv else _nothing
    if argv and argv[0] not in shell.functions and too_long(argv, env):
        main = list_too_long(argv[0], shell)
    prepared = Prepared(argv, main, redirected, env, opened, hidden)
    if argv and argv[0] not in shell.functions and argv[0] not in SHELL_BUILTINS:
        restore(shell, hidden)
    return prepared


async def _assign_all(
    shell: Shell, assignments: list[syntax.Assignment], streams: Streams, hidden: dict[str, Cell | None] | None
) -> None:
    """Make the assignments one after the other; with `hidden`, remember what was there, and export them."""
    for assigned in assignments:
        value = await value_of(assigned, shell, streams)
        if "x" in shell.options:
            await tracing.trace(shell, streams, tracing.assigned(assigned, value))
        if hidden is not None:
            name = shell.variables.resolved(assigned.name)
            before = shell.variables.cells.get(name)
            if before is None or "r" not in before.attributes:
                hidden.setdefault(name, before)
                if before is not None:
                    shell.variables.cells[name] = before.copy()
        await assign(assigned, value, shell, streams)
        if hidden is not None or "a" in shell.options:
            shell.variables.export(assigned.name)


async def _nothing(session: Session) -> int:
    return 0
