"""`trap`: commands that run at the end of a shell, at a signal, and after a command that failed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.session.session import KilledBySignal
from day6_core.session.signals import NUMBERS
from day6_core.shell.language.control_flow import Interrupted

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams

SIGNALS = ("EXIT", "ERR", "HUP", "INT", "QUIT", "USR1", "USR2", "PIPE", "ALRM", "TERM", "CHLD", "TSTP", "WINCH")
"""What can be trapped. The last ones are accepted; nothing sends them to a shell here."""
_NUMBERED = {0: "EXIT", **{number: name for name, number in NUMBERS.items()}}


def signal_name(text: str) -> str | None:
    """The name of a signal that is written as `INT`, `SIGINT` or `2`; None for none."""
    if text.isdigit():
        return _NUMBERED.get(int(text))
    name = text.upper().removeprefix("SIG")
    return name if name in (*SIGNALS, *NUMBERS, "DEBUG", "RETURN") else None


async def run_trap(shell: Shell, name: str, streams: Streams) -> None:
    """Run what was trapped; `$?` is what it was before, and is so again afterwards."""
    command = shell.traps.get(name)
    if not command:
        return
    status, line = shell.status, shell.line
    try:
        await shell.run(command, streams, first_line=line)
    finally:
        shell.status, shell.line = status, line


async def run_exit_trap(shell: Shell, streams: Streams, status: int) -> int:
    """At the end of a shell: run its EXIT trap, once; returns its status, which `exit` in the trap changes."""
    from day6_core.shell.language.control_flow import ExitShell

    command = shell.traps.pop("EXIT", "")
    if not command:
        return status
    shell.status = status
    try:
        await shell.run(command, streams)
    except ExitShell as end:
        return end.status
    return status


def trapped(shell: Shell, error: BaseException) -> str:
    """The name of the signal that raised `error`, if there is a trap for it; else ''."""
    if isinstance(error, (Interrupted, KeyboardInterrupt)):
        name = "INT"
    elif isinstance(error, KilledBySignal):
        name = _NUMBERED.get(error.number, "")
    else:
        return ""
    return name if name in shell.traps else ""
