"""Runs parsed command lines: pipelines, lists, background jobs. `simple` prepares commands, `compound` runs loops and conditions.

Every simple command, built-in or not, runs as a program of its own with a session (so Ctrl-C, pipes and `timeout` need no
special cases); built-ins that change the shell reach it by `shell_of`. Commands in a pipeline, in `( )` and in the
background work on a copy.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Mapping
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from day6_core.session.program import Program
from day6_core.session.session import KilledBySignal, Main, Session
from day6_core.session.signals import NUMBERS
from day6_core.session.streams import InputStream, OutputStream
from day6_core.shell.language import parser, substitution, syntax
from day6_core.shell.language.arithmetic import evaluate
from day6_core.shell.language.compound import run_compound
from day6_core.shell.language.control_flow import DiscardLine, Interrupted, LoopControl, ReturnFromSource
from day6_core.shell.language.failures import after_failure, after_problem, is_last_itself, report
from day6_core.shell.language.hints import Printed, hint_at_syntax, hint_below_command
from day6_core.shell.language.jobs import Job, JobTable
from day6_core.shell.language.pipelines import run_timed, start_stages, take_statuses
from day6_core.shell.language.redirection import Streams, descriptors_of, forked
from day6_core.shell.language.refusals import Refused, check
from day6_core.shell.language.shell_state import NOT_FOUND, ShellState
from day6_core.shell.language.simple import Prepared, prepare
from day6_core.shell.language.specials import add_specials, copy_specials
from day6_core.shell.language.subshells import subshell_main, write_error
from day6_core.shell.language.traps import run_trap, trapped
from day6_core.shell.language.words import SyntaxProblem
from day6_core.shell.runs import Ran

if TYPE_CHECKING:
    from day6_core.shell.desk import Desk
    from day6_core.shell.runs import Run, Runs

_NO_FUNCTIONS = ("command", "builtin", "exec")
"""What runs a command of that name even where there is a function."""


class Shell(ShellState):
    """One shell on a desk: its state, and the jobs that it has started."""

    def __init__(self, desk: Desk, *, env: Mapping[str, str], cwd: Path, interactive: bool, name: str = "bash") -> None:
        super().__init__(env=env, cwd=cwd, interactive=interactive, name=name, pid=desk.new_pid())
        self.desk = desk
        self.jobs = JobTable()
        self.outer_jobs: JobTable | None = None
        """In a subshell the table of the shell around it, which `jobs` shows as long as there are none of its own."""
        self.condition_depth = 0
        """The nesting depth of conditions of `if` and `while`, in which `set -e` does not apply."""
        self.substitution_status = 0
        """Status of the last `$(…)` in the command being prepared: that of an assignment is this one's."""
        self.substitutions = 0
        """How many `$(…)` it is in."""
        self.made_files: list[Path] = []
        """Files of `<(…)` that the command being prepared will read."""
        self.kept = ExitStack()
        """Closes what `exec` has opened."""
        self.listeners: list[Program] = []
        """What reads in `>(…)`."""
        self._front: list[Job] = []
        """Jobs being waited for, the innermost last."""
        self._interrupted = False
        """Whether Ctrl-C came between two commands of the line."""
        self.last_command = ""
        """The name of the simple command that it ran last."""
        self.program: Session | None = None
        """What it runs in as a subshell."""
        self.runs: Runs | None = None
        """What the script of `day6-tui exec` has printed, if something in it will ask `why`; a terminal has its own."""
        self.typed: Run | None = None
        """The line typed in a terminal whose commands it runs: they are kept there."""
        self.command_now: syntax.SimpleCommand | None = None
        """The last one that it has begun to run."""
        self.wanted: WeakKeyDictionary[Session, Exception] = WeakKeyDictionary()
        """What built-ins request after they have returned: to exit, to break out of a loop …"""
        self.streams_of: WeakKeyDictionary[Session, Streams] = WeakKeyDictionary()
        """All streams of the built-ins that run, with those beyond the first three."""
        self.variables.evaluate = lambda text: evaluate(text, self.variables)
        add_specials(self)

    # -- for its users -------------------------------------------------------------------------------------------------

    @property
    def front(self) -> Job | None:
        """The job that has the terminal now."""
        return self._front[-1] if self._front else None

    def interrupt(self) -> bool:
        """Ctrl-C for the innermost foreground job; False if there is none."""
        if self.traps.get("INT") == "":
            return True
        front = self.front
        if front is None:
            return False
        front.interrupt()
        return True

    def interrupt_behind(self) -> None:
        """Ctrl-C has reached the process at the keyboard through its terminal: it is for those behind it in the pipeline, too."""
        if self.front is not None and self.traps.get("INT") != "":
            self.front.interrupt_behind()

    def interrupt_line(self) -> None:
        """Ctrl-C at the terminal: for the foreground job or, between two commands, for the line, as bash gets it too."""
        self._interrupted = not self.interrupt()

    async def run_typed(self, source: str, streams: Streams) -> None:
        """Run what was typed at the terminal, with Ctrl-C and whatever else ends a line early. Raises ExitShell."""
        self._interrupted = False
        try:
            await self.run(source, streams)
        except Interrupted:
            self.status = 130
        except (LoopControl, ReturnFromSource):
            return

    def quit(self) -> bool:
        """Ctrl-\\ for the foreground job: ends programs that do not listen to Ctrl-C."""
        front = self.front
        if front is None:
            return False
        front.send(NUMBERS["QUIT"])
        return True

    def suspend(self) -> bool:
        """Ctrl-Z for the foreground job."""
        front = self.front
        if front is None:
            return False
        front.stop()
        return True

    def may_leave(self, told: OutputStream) -> bool:
        """Whether `exit` and Ctrl-D may end it: with stopped jobs only a second time in a row, or after `jobs`."""
        if not self.jobs.any_stopped or self.last_command in ("exit", "jobs"):
            return True
        told.write("There are stopped jobs.\n")
        self.last_command = "exit"
        return False

    def clone(self) -> Shell:
        """A copy for a subshell: changes to it do not come back, and it has no jobs of its own."""
        twin = Shell(self.desk, env={}, cwd=self.cwd, interactive=False, name=self.name)
        twin.inherit(self)
        copy_specials(twin, self.variables)
        twin.unbound_status = 1
        twin.condition_depth = self.condition_depth
        twin.substitutions = self.substitutions
        twin.runs, twin.typed = self.runs, self.typed
        twin.outer_jobs = self.jobs if self.outer_jobs is None or self.jobs.jobs else self.outer_jobs
        return twin

    async def close_streams(self) -> None:
        """At the end of this shell: close what `exec` has opened, and wait for what reads from it."""
        self.kept.close()
        for program in self.listeners:
            await program.wait()

    # -- running -------------------------------------------------------------------------------------------------------

    async def run(self, source: str, streams: Streams, *, first_line: int = 1) -> int:
        """Run command lines; messages about wrong ones go to `streams.stderr`. Returns the last status.

        Raises ExitShell, and LoopControl or ReturnFromSource where those built-ins were used.
        """
        try:
            lines = parser.lines(source, self.aliases, self.settings, first_line)
            for line in lines:
                check(line, self.functions)
                try:
                    await self.run_tree(line, streams)
                except DiscardLine:
                    lines.send(self.line)
        except SyntaxProblem as problem:
            report(self, problem, streams, before_the_line=True)
            if streams.stderr.isatty() and not isinstance(problem, Refused):
                streams.stderr.write(hint_at_syntax(self, source))
            self.status = problem.status
        return self.status

    # -- for programs (day6_core/session/host.Host) -------------------------------------------------------------------------

    starts_programs = True

    async def run_line(self, source: str, session: Session) -> int:
        """Run command lines for a program, on its streams; for commands that start others (`ros2 run --prefix`)."""
        return await self.run(source, self.all_streams(session))

    def all_streams(self, session: Session) -> Streams:
        """The streams of a command that this shell runs."""
        return self.streams_of.get(session) or Streams(session.stdin, session.stdout, session.stderr)

    def note(self, session: Session, *, is_function: bool = False) -> None:
        """Keep what command a session runs from now on, if what this shell runs is kept: what it prints, how it ends."""
        if self.typed is None:
            return
        now_ns = self.desk.clock.now_ns
        ran = Ran(session.argv, self.command_now, session.cwd, now_ns(), is_function)
        self.typed.note(ran)
        session.stdout, session.stderr = ran.overhear(session.stdout, session.stderr)
        session.defer(lambda: ran.end(session.status, now_ns()))

    def becomes(self, session: Session, before: list[str]) -> None:
        if session.argv:  # not for `A=1 | …`
            self.note(session, is_function=session.argv[0] in self.functions and before[0] not in _NO_FUNCTIONS)

    def command(self, name: str) -> Main | None:
        """The built-in command of that name."""
        from day6_core.shell.commands import builtin

        return builtin(name)

    @property
    def terminals(self) -> tuple[str, ...]:
        """Names of the commands that open a terminal."""
        from day6_core.shell.commands import MODULES

        return tuple(MODULES["terminals"])

    def start_beside(
        self,
        argv: list[str],
        main: Main,
        stdout: OutputStream,
        stderr: OutputStream,
        *,
        env: dict[str, str],
        cwd: Path,
        stdin: InputStream | None = None,
    ) -> Program:
        """Start a program in the background; for a launch and for windows. Raises BlockingIOError."""
        streams = Streams(stdin or InputStream(), stdout, stderr)
        program = self.desk.start_program(argv, main, streams, env=env, cwd=cwd, shell=self)
        program.session.background = True
        return program

    # -- the parts of a line -------------------------------------------------------------------------------------------

    async def run_tree(self, tree: syntax.Sequence, streams: Streams) -> int:
        for item in tree.items:
            try:
                await self._and_or(item, streams)
            except (Interrupted, KeyboardInterrupt, KilledBySignal) as error:
                name = trapped(self, error)
                if not name:
                    raise
                self.status = 128 + NUMBERS[name]
                await run_trap(self, name, streams)
        return self.status

    async def output_of(self, source: str, streams: Streams) -> str:
        """`$(source)`: what the commands print, without the newlines at the end."""
        return (await substitution.captured_output(self, source, streams)).rstrip("\n")

    async def _and_or(self, node: syntax.AndOr, streams: Streams) -> None:
        if node.background:
            try:
                await self._background(node, streams)
            except SyntaxProblem as problem:
                report(self, problem, streams)
                self.status = 1
            return
        last = node.items[-1][1]
        for index, (operator, pipeline) in enumerate(node.items):
            if index and (self.status == 0) != (operator == "&&"):
                if pipeline is last:
                    return
                continue
            asked = pipeline is not last  # a command before && or || may fail, even with `set -e`
            self.condition_depth += asked
            try:
                await self.run_pipeline(pipeline, streams)
            except SyntaxProblem as problem:
                after_problem(self, problem, streams)
            finally:
                self.condition_depth -= asked
        if self.status and not last.negated and not self.condition_depth:
            await after_failure(self, last, streams)

    async def _background(self, node: syntax.AndOr, streams: Streams) -> None:
        stdin = streams.stdin.fork() if self.interactive else InputStream()
        streams = Streams(stdin, streams.stdout, streams.stderr, dict(streams.more))
        inner = self.clone()
        inner.background = True
        inner.unbound_status = self.unbound_status
        if len(node.items) == 1 and not node.items[0][1].negated:
            programs = start_stages(inner, node.items[0][1], streams)
        else:
            foreground = replace(node, background=False)
            main = subshell_main(inner, lambda: inner.run_tree(syntax.Sequence([foreground]), streams), streams)
            programs = [inner.start([node.source], main, streams)]
        job = Job(programs, node.source, stdin)
        self.jobs.add(job)
        self.last_background = programs[-1].pid
        self.status = 0
        if self.interactive:
            streams.stderr.write(f"[{job.number}] {programs[-1].pid}\n")

    async def run_pipeline(self, node: syntax.Pipeline, streams: Streams) -> None:
        if node.timed:
            await run_timed(self, node, streams)
            return
        if self._interrupted:
            streams.stderr.write("\n")
            raise Interrupted
        self.line = node.line
        command = node.commands[0]
        if len(node.commands) > 1:
            front = forked(streams)
            programs, printed = start_stages(self, node, front), Printed(front.stdin)
            job = Job(programs, node.source, front.stdin)
            await self._foreground(job, streams)
            take_statuses(self, [program.status or 0 for program in programs])
            missing = next((program for program in programs if program.status == NOT_FOUND), None)
            if missing is not None and self.interactive and streams.stderr.isatty():
                streams.stderr.write(await hint_below_command(self, missing.session.argv, printed, NOT_FOUND))
        elif isinstance(command, syntax.SimpleCommand):
            await self._simple(command, node.source, streams)
            take_statuses(self, [self.status])
        else:
            await run_compound(self, command, streams)
            if is_last_itself(command):
                take_statuses(self, [self.status])
        if node.negated:
            self.status = 0 if self.status else 1

    # -- simple commands -----------------------------------------------------------------------------------------------

    async def _simple(self, command: syntax.SimpleCommand, source: str, streams: Streams) -> None:
        front = forked(streams)
        listeners = len(self.listeners)
        prepared = await prepare(self, command, front)
        if prepared is None:
            self.status = 1
            return
        try:
            if prepared.argv:
                await self._run_prepared(prepared, command, source, front.stdin, streams)
        finally:
            prepared.finish(self)
            self.last_argument = prepared.argv[-1] if prepared.argv else ""
            self.last_command = prepared.argv[0] if prepared.argv else ""
        if "exec" not in prepared.argv[:1]:
            for program in self.listeners[listeners:]:
                await program.wait()
            del self.listeners[listeners:]

    async def _run_prepared(
        self, prepared: Prepared, command: syntax.SimpleCommand, source: str, tty: InputStream, streams: Streams
    ) -> None:
        program = self.start(prepared.argv, prepared.main, prepared.streams, env=prepared.env, shell=self)
        self.note(program.session, is_function=prepared.argv[0] in self.functions)
        self.streams_of[program.session] = prepared.streams
        printed = Printed(tty)
        await self._foreground(Job([program], source, tty), streams)
        if prepared.argv[0] == "exec" and not prepared.argv[1:]:
            self.kept.push(prepared.opened.pop_all())
            streams.take(prepared.streams, descriptors_of(command.redirections))
        prepared.streams.hand_up(streams, command.redirections)
        if self.status and self.interactive and prepared.streams.stderr.isatty():
            prepared.streams.stderr.write(await hint_below_command(self, prepared.argv, printed, self.status))
        if (end := self.wanted.pop(program.session, None)) is not None:
            raise end

    # -- programs and jobs ---------------------------------------------------------------------------------------------

    def start(
        self,
        argv: list[str],
        main: Main,
        streams: Streams,
        *,
        env: dict[str, str] | None = None,
        shell: Shell | None = None,
    ) -> Program:
        environment = self.environment if env is None else env
        try:
            program = self.desk.start_program(argv, main, streams, env=environment, cwd=self.cwd, shell=shell)
        except BlockingIOError as error:
            raise SyntaxProblem(f"fork: {error.strerror}") from None
        program.session.background = self.background
        program.session.on_write_error = write_error
        return program

    async def run_subshell(
        self, inner: Shell, source: str, run: Callable[[], Awaitable[int]], inner_streams: Streams, streams: Streams
    ) -> None:
        """Run `( … )`: `run()` does its work in the copy `inner`, which has the terminal until it ends."""
        program = self.start(["( )"], subshell_main(inner, run, inner_streams), inner_streams)
        await self._foreground(Job([program], source, inner_streams.stdin), streams)

    async def _foreground(self, job: Job, streams: Streams) -> None:
        """Give the job the terminal until it ends or is stopped, and take its status."""
        await self.wait_front(job)
        self._after(job, streams)

    async def wait_front(self, job: Job) -> None:
        self._front.append(job)
        job.tty.focus()
        try:
            await job.wait()
            while job.stopped and not self.interactive:
                # There is no job control in here: what stands still stops all of it, up to what was typed at the terminal.
                if self.program is not None and self.program.on_own_stop is not None:
                    self.program.on_own_stop(job.stopped_by)
                await job.wait_while_stopped()
                await job.wait()
        except BaseException:
            # The shell itself is being ended (a subshell in a pipeline, a closed terminal), and with it all it started.
            job.send(15)
            raise
        finally:
            self._front.remove(job)
            job.tty.unfocus()

    def _after(self, job: Job, streams: Streams) -> None:
        if job.stopped:
            self.put_aside(job, streams)
            return
        self.jobs.remove(job)
        self.status = job.status
        if job.killed_by not in (0, 2, 13):
            streams.stderr.write(f"{job.state}\n")
        if job.interrupted:
            if self.interactive:
                streams.stderr.write("\n")
            raise Interrupted

    def put_aside(self, job: Job, streams: Streams) -> None:
        """Keep a job that was stopped in the foreground, and say so."""
        job.stop()  # all of a pipeline
        self.jobs.add(job)
        job.stop_is_told = True
        streams.stderr.write(f"\n{self.jobs.line(job)}\n")
        self.status = job.status

    async def resume_in_front(self, job: Job, streams: Streams) -> int:
        """`fg`: continue the job here and wait for it."""
        streams.stdout.write(f"{job.source}\n")
        job.resume()
        await self._foreground(job, streams)
        return self.status


def shell_of(session: Session) -> Shell:
    """The shell that runs a built-in. Raises LookupError for a program that no shell has started."""
    if not isinstance(session.host, Shell):
        raise LookupError(f"{session.name}: no shell")
    return session.host
