"""Shell functions: calling one, and `local`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.session.session import Main, Session
from day6_tui.core.shell.language import syntax
from day6_tui.core.shell.language.control_flow import ExitShell, Interrupted, LoopControl, ReturnFromSource
from day6_tui.core.shell.language.redirection import Streams
from day6_tui.core.shell.language.shell_state import MAX_DEPTH

if TYPE_CHECKING:
    from day6_tui.core.shell.language.interpreter import Shell


def calling(function: syntax.Function) -> Main:
    """The program that a call of the function is: it runs in the shell itself, with arguments and `local`s of its own."""

    async def main(session: Session) -> int:
        from day6_tui.core.shell.language.compound import run_compound

        shell: Shell = session.shell
        if shell.depth >= MAX_DEPTH:
            session.print_error(f"{shell.name}: {session.name}: maximum function nesting level exceeded ({MAX_DEPTH})")
            return 1
        before, shell.arguments = shell.arguments, session.argv[1:]
        shell.depth += 1
        shell.hidden.append({})
        shell.status = 0
        try:
            return await run_compound(shell, function.body, Streams(session.stdin, session.stdout, session.stderr))
        except ReturnFromSource as end:
            return end.status
        except (ExitShell, LoopControl, Interrupted) as end:
            session.shell_end = end
            return shell.status
        finally:
            shell.arguments = before
            shell.depth -= 1
            for name, value in shell.hidden.pop().items():
                if value is None:
                    shell.variables.pop(name, None)
                else:
                    shell.variables[name] = value

    return main
