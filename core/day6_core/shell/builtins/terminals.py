"""xterm, gnome-terminal: another terminal of the desktop, also as the `prefix` of a node in a launch file."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from typing import TYPE_CHECKING

from day6_core.session.session import Session
from day6_core.shell.language.interpreter import shell_of

if TYPE_CHECKING:
    from day6_core.shell.terminal import Terminal

_XTERM_VALUES = ("-T", "-title", "-n", "-name", "-geometry", "-fn", "-fa", "-fs", "-bg", "-fg", "-sl", "-xrm", "-class")
"""Options of xterm that take a value and are ignored: the desktop decides the appearance."""


async def xterm(session: Session) -> int:
    """`xterm [-hold] [-e COMMAND …]`: runs until the command, or the shell, in the new terminal has ended."""
    words = session.argv[1:]
    command: list[str] = []
    while words:
        word = words.pop(0)
        if word == "-e":
            command, words = words, []
        elif word in _XTERM_VALUES and words:
            words.pop(0)
    if session.display is None:
        session.print_error("xterm: Xt error: Can't open display: \nxterm: DISPLAY is not set")
        return 1
    terminal = _open(session, command)
    if terminal is None:
        return 1
    # Ctrl-C for xterm closes its window; the desktop ends what still runs in it.
    session.defer(terminal.program.terminate)
    await terminal.program.wait()
    return 0


async def gnome_terminal(session: Session) -> int:
    """`gnome-terminal [-- COMMAND …]`: opens the terminal and does not wait for it."""
    words = session.argv[1:]
    command: list[str] = []
    for number, word in enumerate(words):
        if word in ("--", "-x"):
            command = words[number + 1 :]
            break
        if word in ("-e", "--command"):
            command = words[number + 1 : number + 2]
            break
        if word.startswith(("-e=", "--command=")):
            command = [word.partition("=")[2]]
            break
    if session.display is None:
        session.print_error("# Failed to open display: ")
        return 1
    return 1 if _open(session, command) is None else 0


def _open(session: Session, command: Sequence[str]) -> Terminal | None:
    """Open a terminal; one word is a line for the shell, several are a command and its arguments.

    None, with a message, when too many programs run for one more.
    """
    line = command[0] if len(command) == 1 else shlex.join(command)
    try:
        terminal: Terminal = shell_of(session).desk.open_terminal(cwd=session.cwd, env=session.env, command=line)
    except BlockingIOError as error:
        session.print_error(f"{session.argv[0]}: fork: {error.strerror}")
        return None
    return terminal
