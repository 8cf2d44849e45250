"""The shell of a terminal: `.bashrc`, prompt, reading and running lines, reports about background jobs, the end."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.session.session import Session
from day6_core.shell.desk import Wanted
from day6_core.shell.language import parser
from day6_core.shell.language.control_flow import ExitShell
from day6_core.shell.language.hints import hint_at_open_quote
from day6_core.shell.language.interpreter import Shell
from day6_core.shell.language.words import Incomplete, SyntaxProblem
from day6_core.shell.line.completion import Completer
from day6_core.shell.line.editor import EndOfLines, LineEditor
from day6_core.shell.line.history import History
from day6_core.shell.line.prompt import UBUNTU, prompt
from day6_core.shell.line.recall import NoSuchLine, recalled

if TYPE_CHECKING:
    from day6_core.shell.terminal import Terminal

LINES_TO_A_HINT = 3
"""Lines of one command, the last two typed at `> `, after which an open quotation mark is told."""


async def login(session: Session, terminal: Terminal) -> int:
    """The program of a terminal's shell."""
    shell = terminal.shell
    streams = terminal.streams
    history = History(terminal.desk.home / ".bash_history")
    shell.history = history.lines
    shell.variables.setdefault("PS1", UBUNTU)
    editor = LineEditor(session, terminal, history, Completer(shell, session))
    session.on_interrupt = shell.interrupt
    try:
        if Path(shell.variables.get("HOME", "/"), ".bashrc").is_file():
            await shell.run_typed('source "$HOME/.bashrc"', streams)
        while True:
            for line in shell.jobs.take_news():
                session.print(line)
            if not terminal.at_line_start:
                session.print()
            try:
                source = await _read_command(editor, shell, terminal)
            except EndOfLines:
                session.print("exit")
                if terminal.discipline.hung_up or shell.may_leave(session.stdout):
                    return shell.status
                continue
            if source.strip():
                history.add(source)
                shell.wanted_distribution = "" if terminal.desk.may_change_distribution else None
                shell.typed = terminal.runs.begin(source, shell.cwd, terminal.desk.clock.now_ns())
                try:
                    await shell.run_typed(source, streams)
                finally:
                    terminal.runs.end(shell.status, terminal.desk.clock.now_ns())
                    shell.typed = None
                if shell.wanted_distribution:
                    terminal.desk.wanted_distribution = Wanted(shell.wanted_distribution, terminal, source)
    except ExitShell as end:
        return end.status
    finally:
        shell.jobs.hang_up()
        streams.stdout.flush()


async def run_command(session: Session, terminal: Terminal, command: str) -> int:
    """The program of a terminal that was opened for one command."""
    shell = terminal.shell
    session.on_interrupt = shell.interrupt
    try:
        await shell.run_typed(command, terminal.streams)
        return shell.status
    except ExitShell as end:
        return end.status
    finally:
        shell.jobs.hang_up()


async def _read_command(editor: LineEditor, shell: Shell, terminal: Terminal) -> str:
    """Read lines until they make whole commands; '' after Ctrl-C. Raises EndOfLines at the end of the input."""
    source, lines = "", 0
    streams = terminal.streams
    shown = await prompt(shell, streams)
    while True:
        terminal.unfinished = source
        try:
            typed = await editor.read(shown)
        finally:
            terminal.unfinished = ""
        if typed is None:
            shell.status = 130
            return ""
        try:
            line = recalled(typed, shell.history)
        except NoSuchLine as problem:
            streams.stderr.write(f"{shell.name}: {problem}\n")
            return ""
        if line != typed:
            streams.stdout.write(f"{line}\n")
        source += line
        try:
            parser.parse(source, shell.aliases)
        except Incomplete as problem:
            source, lines = source + "\n", lines + 1
            if lines == LINES_TO_A_HINT and (hint := hint_at_open_quote(shell, str(problem))):
                streams.stderr.write(hint)
            shown = shell.variables.get("PS2", "> ")
            continue
        except SyntaxProblem:
            return source
        return source
