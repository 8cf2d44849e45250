"""The programs of subshells: what runs in a copy of the shell, and how its end becomes a status."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING

from day6_core.session.session import KilledBySignal, Main, Session
from day6_core.session.write_errors import report_write_error
from day6_core.shell.language.control_flow import DiscardLine, ExitShell, Interrupted, LoopControl, ReturnFromSource
from day6_core.shell.language.shell_state import MAX_DEPTH
from day6_core.shell.language.traps import run_exit_trap

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams


def subshell_main(inner: Shell, run: Callable[[], Awaitable[int]], streams: Streams | None = None) -> Main:
    """The program of a subshell: `run()` does its work in the copy `inner`, whose trap at its end prints to `streams`."""

    async def main(session: Session) -> int:
        def on_stop(stopped: bool) -> None:
            if inner.front is not None and stopped:
                inner.front.stop()
            elif inner.front is not None:
                inner.front.resume()

        session.on_interrupt = inner.interrupt
        session.on_stop = on_stop
        inner.own_pid = session.pid
        inner.program = session
        if inner.depth > MAX_DEPTH:
            session.print_error(inner.too_deep)
            return 1
        try:
            return await whole_run(inner, run, streams or inner.all_streams(session))
        finally:
            for job in inner.jobs.jobs:
                job.send(15)

    return main


async def whole_run(shell: Shell, run: Callable[[], Awaitable[int]], streams: Streams) -> int:
    """Run a shell to its end, with its EXIT trap; returns the status. Raises KeyboardInterrupt after Ctrl-C."""
    try:
        status = await run()
    except ExitShell as end:
        status = end.status
    except (LoopControl, ReturnFromSource, DiscardLine):
        status = shell.status
    except Interrupted:
        await run_exit_trap(shell, streams, 130)
        await shell.close_streams()
        raise KeyboardInterrupt from None
    except KilledBySignal as end:
        await run_exit_trap(shell, streams, 128 + end.number)
        await shell.close_streams()
        raise
    status = await run_exit_trap(shell, streams, status)
    await shell.close_streams()
    return status


def write_error(session: Session, error: OSError) -> int:
    """Report that a command's output could not be written, as bash does for its built-ins; return the status."""
    from day6_core.shell.commands import SHELL_BUILTINS
    from day6_core.shell.language.interpreter import Shell

    if not isinstance(session.host, Shell) or session.name not in SHELL_BUILTINS:
        return report_write_error(session, error)
    session.print_error(f"{session.host.name}: {session.name}: write error: {error.strerror}")
    return 1
