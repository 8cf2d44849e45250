"""What follows when a command fails or cannot be prepared: a message, `trap … ERR`, `set -e`, the end of the line."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.shell.language import syntax
from day6_core.shell.language.control_flow import DiscardLine, ExitShell
from day6_core.shell.language.parameters import ExpansionProblem, UnboundProblem
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.refusals import Refused
from day6_core.shell.language.traps import run_trap
from day6_core.shell.language.variables import ReadOnlyProblem
from day6_core.shell.language.words import SyntaxProblem

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell


def report(shell: Shell, problem: SyntaxProblem, streams: Streams, *, before_the_line: bool = False) -> None:
    """Print what is wrong with a line."""
    told = problem.told(shell.variables, before_the_line=before_the_line) if isinstance(problem, Refused) else problem
    streams.stderr.write(f"{shell.name}: {told}\n")


def after_problem(shell: Shell, problem: SyntaxProblem, streams: Streams) -> None:
    """Report a command that could not be prepared, and end as much as bash ends. Raises ExitShell and DiscardLine."""
    report(shell, problem, streams)
    shell.status = 2 if isinstance(problem, Refused) else 1
    if isinstance(problem, Refused) and not shell.interactive:
        raise ExitShell(2)
    if isinstance(problem, UnboundProblem) and not shell.interactive:
        raise ExitShell(shell.unbound_status)
    if isinstance(problem, (ExpansionProblem, ReadOnlyProblem, Refused)):
        raise DiscardLine


async def after_failure(shell: Shell, last: syntax.Pipeline, streams: Streams) -> None:
    """`trap … ERR` and `set -e`. What failed in `{ }`, a loop or a condition was looked at there."""
    if "ERR" in shell.traps:
        command = last.commands[-1]
        if len(last.commands) > 1 or not isinstance(command, syntax.COMPOUND) or is_last_itself(command):
            await run_trap(shell, "ERR", streams)
    if "e" in shell.options:
        raise ExitShell(shell.status)


def is_last_itself(command: syntax.Command) -> bool:
    """Whether the status is the command's own rather than that of the last one in it."""
    return isinstance(command, (syntax.Conditional, syntax.Arithmetic)) or (
        isinstance(command, syntax.Group) and command.subshell
    )
