"""Code that runs in the shell itself, one level deeper: a sourced file, and a shell function with its `local`s."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING

from day6_core.session.session import Main, Session
from day6_core.shell.language import syntax
from day6_core.shell.language.control_flow import DiscardLine, ExitShell, Interrupted, LoopControl, ReturnFromSource
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.shell_state import MAX_DEPTH

if TYPE_CHECKING:
    pass


async def in_the_shell_itself(session: Session, run: Callable[[Streams], Awaitable[int]], too_deep: str) -> int:
    """Run something of the language in the shell of `session`, one level deeper, on its streams; returns the status.

    `return` ends it; `exit`, `break` and Ctrl-C end it too and are handed on to the shell.
    """
    from day6_core.shell.language.interpreter import shell_of

    shell = shell_of(session)
    if shell.depth >= MAX_DEPTH:
        session.print_error(f"{shell.name}: {session.name}: {too_deep} ({MAX_DEPTH})")
        return 1
    shell.depth += 1
    shell.status = 0
    try:
        return await run(Streams(session.stdin, session.stdout, session.stderr))
    except ReturnFromSource as end:
        return end.status
    except (ExitShell, LoopControl, DiscardLine, Interrupted) as end:
        shell.wanted[session] = end
        return shell.status
    finally:
        shell.depth -= 1


def calling(function: syntax.Function) -> Main:
    """Return the program for a call of the function: it runs in the shell itself, with its own arguments and `local`s."""

    async def main(session: Session) -> int:
        from day6_core.shell.language.compound import run_compound
        from day6_core.shell.language.interpreter import shell_of

        shell = shell_of(session)
        before, shell.arguments = shell.arguments, session.argv[1:]
        shell.hidden.append({})
        try:
            return await in_the_shell_itself(
                session,
                lambda streams: run_compound(shell, function.body, streams),
                "maximum function nesting level exceeded",
            )
        finally:
            shell.arguments = before
            for name, value in shell.hidden.pop().items():
                if value is None:
                    shell.variables.pop(name, None)
                else:
                    shell.variables[name] = value

    return main
