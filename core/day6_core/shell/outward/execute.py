"""`day6-tui exec`: lines of the simulated terminal without a screen, on the real standard input, output and error."""

from __future__ import annotations

import io
import os
import signal
import sys
from pathlib import Path
from typing import TextIO

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.command_line.values import Values
from day6_core.language import VARIABLE, language_of
from day6_core.session.folder import working_folder
from day6_core.session.program import Program
from day6_core.session.real_streams import RealInput, RealOutput
from day6_core.session.scheduler import STUCK_SECONDS
from day6_core.session.session import Session
from day6_core.session.signals import from_system
from day6_core.session.streams import InputStream
from day6_core.shell.builtins.why import is_own
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.subshells import whole_run
from day6_core.shell.outward.fast import begin_anew_or_say
from day6_core.shell.runs import Run, Runs
from day6_core.virtual.surroundings import is_virtual

TIMED_OUT = 124


class KeptOutput(RealOutput):
    """Our own output, of which the end is kept for `why`; so what a script starts writes through this, too."""

    def __init__(self, file: TextIO, run: Run) -> None:
        super().__init__(file)
        self._run = run

    def write(self, text: str) -> int:
        """Write and keep. Raises BrokenPipeError and WriteError."""
        self._run.keep(text)
        return super().write(text)

    def fileno(self) -> int | None:
        """None: a process with the descriptor would write past us."""
        return None


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui exec`, and what it takes."""
    parser = command_parser("exec", language)
    texts, values = parser.texts, Values(parser.texts)
    parser.add_argument("-c", dest="commands", metavar="COMMANDS", help=texts("cli.exec.commands"))
    parser.add_argument("file", nargs="?", metavar="FILE", help=texts("cli.exec.file"))
    parser.add_argument("arguments", nargs="*", metavar="ARG", help=texts("cli.exec.arguments"))
    parser.add_argument("--home", type=values.home, metavar="DIR", help=texts("cli.options.home"))
    parser.add_argument("--fast", action="store_true", help=texts("cli.fast"))
    parser.add_argument("--timeout", type=values.seconds, metavar="S", help=texts("cli.exec.timeout", status=TIMED_OUT))
    return parser


def main(arguments: list[str]) -> int:
    """Run `day6-tui exec ARGUMENTS` and return the status to exit with."""
    language = language_of(os.environ, arguments)
    parser = build_parser(language)
    options = parser.parse_args(arguments)
    if options.lang is not None:
        os.environ[VARIABLE] = language
    if options.fast and not is_virtual():
        return begin_anew_or_say(parser, sys.orig_argv, os.environ)
    words = list(options.arguments)
    commands: str | None = options.commands
    name = "bash"
    stdin: RealInput | None = RealInput()
    if commands is not None:
        words = ([options.file] if options.file is not None else []) + words
    elif options.file is not None:
        try:
            commands = Path(options.file).read_text(encoding="utf-8", errors="surrogateescape")
        except OSError as error:
            print(f"day6-tui exec: {options.file}: {error.strerror}", file=sys.stderr)
            return 127
    else:
        if isinstance(sys.stdin, io.TextIOWrapper):
            sys.stdin.reconfigure(encoding="utf-8", errors="surrogateescape")
        commands = sys.stdin.read()
        stdin = None
    try:
        desk = Desk(options.home, display=False)
    except OSError as error:
        reason = f"{error.filename}: {error.strerror}" if error.strerror else error
        print(f"{parser.prog}: {parser.texts('cli.exec.home.failed', reason=reason)}", file=sys.stderr)
        return 1
    return run(desk, commands, words, name=name, stdin=stdin, timeout=options.timeout)


def run(
    desk: Desk, commands: str, arguments: list[str], *, name: str, stdin: RealInput | None, timeout: float | None
) -> int:
    """Run command lines on a desk that is not running yet, in this thread; close the desk."""
    shell = desk.shell(cwd=working_folder())
    shell.name = name
    shell.arguments = arguments
    stdout, stderr = RealOutput(sys.stdout), RealOutput(sys.stderr)
    if is_own(commands):
        shell.runs = Runs()
        kept = shell.runs.begin(commands, shell.cwd, desk.clock.now_ns())
        stdout, stderr = KeptOutput(sys.stdout, kept), KeptOutput(sys.stderr, kept)
    streams = Streams(stdin if stdin is not None else InputStream(), stdout, stderr)

    async def script(session: Session) -> int:
        session.on_interrupt = shell.interrupt
        return await whole_run(shell, lambda: shell.run(commands, streams), streams)

    desk.link_on_demand()
    program = desk.start_program([name], script, streams, env=shell.environment, cwd=shell.cwd, shell=shell)
    status = TIMED_OUT
    before = _handle_signals(desk, program)
    try:
        if desk.scheduler.run(lambda: program.status is not None, timeout):
            status = program.status or 0
    finally:
        # What still runs is in the background: closing a terminal ends it silently.
        stdout.mute()
        stderr.mute()
        desk.close()
        for number, handler in before.items():
            signal.signal(number, handler)
        if stdin is not None:
            stdin.restore()
    return status


def _handle_signals(desk: Desk, program: Program) -> dict[int, signal._HANDLER]:
    """Ctrl-C goes to what runs in the foreground; SIGTERM and SIGHUP end the script. Returns the handlers before."""

    def interrupt(number: int, frame: object) -> None:
        desk.scheduler.call_soon_threadsafe(program.interrupt)
        if desk.scheduler.stuck_for > STUCK_SECONDS:
            raise KeyboardInterrupt

    def terminate(number: int, frame: object) -> None:
        desk.scheduler.call_soon_threadsafe(lambda: program.send(from_system(number)))
        if desk.scheduler.stuck_for > STUCK_SECONDS:
            raise KeyboardInterrupt

    wanted = {signal.SIGINT: interrupt, signal.SIGTERM: terminate}
    if sys.platform != "win32":
        wanted[signal.SIGHUP] = terminate
    return {number: signal.signal(number, handler) for number, handler in wanted.items()}
