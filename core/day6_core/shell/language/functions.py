"""Code that runs in the shell itself, one level deeper: a sourced file, and a shell function with its `local`s."""

from __future__ import annotations

from collections.abc import Awaitable, Callable

from day6_core.session.session import Main, Session
from day6_core.shell.language import syntax
from day6_core.shell.language.control_flow import DiscardLine, ExitShell, Interrupted, LoopControl, ReturnFromSource
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.shell_state import MAX_DEPTH
from day6_core.shell.language.simple import restore
from day6_core.shell.language.specials import Call


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
    line = shell.line
    try:
        return await run(shell.all_streams(session))
    except ReturnFromSource as end:
        return end.status
    except (ExitShell, LoopControl, DiscardLine, Interrupted) as end:
        shell.wanted[session] = end
        return shell.status
    finally:
        shell.depth -= 1
        shell.line = line


def calling(function: syntax.Function) -> Main:
    """Return the program for a call of the function: it runs in the shell itself, with its own arguments and `local`s."""

    async def main(session: Session) -> int:
        from day6_core.shell.language.compound import run_compound
        from day6_core.shell.language.interpreter import shell_of

        shell = shell_of(session)
        most = shell.variables.get("FUNCNEST", "")
        if most.isdigit() and 0 < int(most) <= len(shell.hidden):
            session.print_error(f"{shell.name}: {function.name}: maximum function nesting level exceeded ({most})")
            shell.wanted[session] = DiscardLine()
            return 1
        before, shell.arguments = shell.arguments, session.argv[1:]
        shell.hidden.append({})
        loops, shell.loops = shell.loops, 0
        on_error = None if "E" in shell.options else shell.traps.pop("ERR", None)
        shell.calls.append(Call(function.name, function.file or "environment", shell.line))
        try:
            return await in_the_shell_itself(
                session,
                lambda streams: run_compound(shell, function.body, streams),
                "maximum function nesting level exceeded",
            )
        finally:
            shell.arguments, shell.loops = before, loops
            shell.calls.pop()
            if on_error is not None:
                shell.traps.setdefault("ERR", on_error)
            restore(shell, shell.hidden.pop())

    return main
