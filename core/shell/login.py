"""The shell of a terminal: `.bashrc`, prompt, reading lines, running them, news of background jobs, the end."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.session.session import Session
from day6_tui.core.shell import syntax
from day6_tui.core.shell.completion import Completer
from day6_tui.core.shell.control_flow import ExitShell, Interrupted, LoopControl, ReturnFromSource
from day6_tui.core.shell.history import History
from day6_tui.core.shell.interpreter import Shell
from day6_tui.core.shell.lexer import Incomplete, SyntaxProblem
from day6_tui.core.shell.line_editor import EndOfLines, LineEditor

if TYPE_CHECKING:
    from day6_tui.core.shell.terminal import Terminal

_GREEN, _BLUE, _PLAIN = "\x1b[01;32m", "\x1b[01;34m", "\x1b[00m"


def prompt(shell: Shell) -> str:
    """`student@day6:~/ros2_ws$ ` in Ubuntu's colours."""
    from day6_tui.core.shell.desk import HOST, USER

    return f"{_GREEN}{USER}@{HOST}{_PLAIN}:{_BLUE}{shell.short_cwd}{_PLAIN}$ "


async def login(session: Session, terminal: Terminal) -> int:
    """The program of a terminal's shell."""
    shell = terminal.shell
    streams = terminal.streams
    history = History(terminal.desk.home / ".bash_history")
    shell.history = history.lines
    editor = LineEditor(session, terminal, history, Completer(shell, session))
    session.on_interrupt = shell.interrupt
    try:
        if (terminal.desk.home / ".bashrc").is_file():
            await _run(shell, 'source "$HOME/.bashrc"', terminal)
        warned = False
        while True:
            for line in shell.jobs.take_finished():
                session.print(line)
            if not terminal.at_line_start:
                session.print()
            try:
                source = await _read_command(editor, shell)
            except EndOfLines:
                if any(job.stopped for job in shell.jobs.jobs) and not warned and not terminal.discipline.hung_up:
                    session.print("exit\nThere are stopped jobs.")
                    warned = True
                    continue
                session.print("exit")
                return shell.status
            warned = False
            if source.strip():
                history.add(source)
                await _run(shell, source, terminal)
    except ExitShell as end:
        return end.status
    finally:
        for job in shell.jobs.jobs:
            job.send(1)
        streams.stdout.flush()


async def _read_command(editor: LineEditor, shell: Shell) -> str:
    """Read lines until they make whole commands; '' after Ctrl-C. Raises EndOfLines at the end of the input."""
    source = ""
    shown = prompt(shell)
    while True:
        line = await editor.read(shown)
        if line is None:
            shell.status = 130
            return ""
        source += line
        try:
            syntax.parse(source)
        except Incomplete:
            source += "\n"
            shown = "> "
            continue
        except SyntaxProblem:
            return source
        return source


async def _run(shell: Shell, source: str, terminal: Terminal) -> None:
    try:
        await shell.run(source, terminal.streams)
    except Interrupted:
        shell.status = 130
    except (LoopControl, ReturnFromSource):
        return
