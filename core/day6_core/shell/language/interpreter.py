"""Runs parsed command lines: simple commands, pipelines, lists, background jobs. `compound` runs the loops and conditions.

Every simple command, built-in or not, runs as a program of its own with a session (so Ctrl-C, pipes and `timeout` need no
special cases); built-ins that change the shell reach it by `shell_of`. Commands in a pipeline, in `( )` and in the
background work on a copy.
"""

from __future__ import annotations

import os
from collections.abc import Awaitable, Callable
from contextlib import ExitStack, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from day6_core.session.program import Program
from day6_core.session.session import Main, Session
from day6_core.session.signals import NUMBERS
from day6_core.session.streams import CAPTURE_LIMIT, Captured, InputStream, OutputStream, Pipe
from day6_core.session.write_errors import report_write_error
from day6_core.shell.language import parser, syntax
from day6_core.shell.language.compound import run_compound
from day6_core.shell.language.control_flow import DiscardLine, ExitShell, Interrupted, LoopControl, ReturnFromSource
from day6_core.shell.language.expansion import ExpansionProblem, UnboundProblem, expand, expand_text
from day6_core.shell.language.hints import Printed, hint_at_syntax, hint_below_command
from day6_core.shell.language.jobs import Job, JobTable
from day6_core.shell.language.redirection import Streams, redirect
from day6_core.shell.language.shell_state import MAX_DEPTH, NOT_FOUND, ShellState
from day6_core.shell.language.words import SyntaxProblem, Word

if TYPE_CHECKING:
    from day6_core.shell.desk import Desk
    from day6_core.shell.runs import Runs

LONGEST_VALUE = 16 * 1024 * 1024
"""Characters of a variable. A bash that keeps doubling one ends with this message too, once memory is used up."""


class Shell(ShellState):
    """One shell on a desk: its state, and the jobs that it has started."""

    def __init__(self, desk: Desk, *, env: dict[str, str], cwd: Path, interactive: bool, name: str = "bash") -> None:
        super().__init__(env=env, cwd=cwd, interactive=interactive, name=name, pid=desk.new_pid())
        self.desk = desk
        self.jobs = JobTable()
        self.outer_jobs: JobTable | None = None
        """In a subshell the table of the shell around it, which `jobs` shows as long as there are none of its own."""
        self.condition_depth = 0
        """The nesting depth of conditions of `if` and `while`, in which `set -e` does not apply."""
        self._substitution_status = 0
        """Status of the last `$(…)` in the command being prepared: that of an assignment is this one's."""
        self._front: list[Job] = []
        """Jobs being waited for, the innermost last."""
        self._interrupted = False
        """Whether Ctrl-C came between two commands of the line."""
        self.runs: Runs | None = None
        """What the script of `day6-tui exec` has printed, if something in it will ask `why`; a terminal has its own."""
        self.wanted: WeakKeyDictionary[Session, Exception] = WeakKeyDictionary()
        """What built-ins request after they have returned: to exit, to break out of a loop …"""

    # -- for its users -------------------------------------------------------------------------------------------------

    @property
    def front(self) -> Job | None:
        """The job that has the terminal now."""
        return self._front[-1] if self._front else None

    def interrupt(self) -> bool:
        """Ctrl-C for the innermost foreground job; False if there is none."""
        front = self.front
        if front is None:
            return False
        front.interrupt()
        return True

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

    def clone(self) -> Shell:
        """A copy for a subshell: changes to it do not come back, and it has no jobs of its own."""
        twin = Shell(self.desk, env=dict(self.variables), cwd=self.cwd, interactive=False, name=self.name)
        twin.inherit(self)
        twin.unbound_status = 1
        twin.runs = self.runs
        twin.outer_jobs = self.jobs if self.outer_jobs is None or self.jobs.jobs else self.outer_jobs
        return twin

    # -- running -------------------------------------------------------------------------------------------------------

    async def run(self, source: str, streams: Streams) -> int:
        """Run command lines; messages about wrong ones go to `streams.stderr`. Returns the last status.

        Raises ExitShell, and LoopControl or ReturnFromSource where those built-ins were used.
        """
        try:
            for line in parser.lines(source, self.aliases):
                with suppress(DiscardLine):
                    await self.run_tree(line, streams)
        except SyntaxProblem as problem:
            streams.stderr.write(f"{self.name}: {problem}\n")
            if streams.stderr.isatty():
                streams.stderr.write(hint_at_syntax(self, source))
            self.status = 2
        return self.status

    # -- for programs (day6_core/session/host.Host) -------------------------------------------------------------------------

    starts_programs = True

    async def run_line(self, source: str, session: Session) -> int:
        """Run command lines for a program, on its streams; for commands that start others (`ros2 run --prefix`)."""
        return await self.run(source, Streams(session.stdin, session.stdout, session.stderr))

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
            await self._and_or(item, streams)
        return self.status

    async def output_of(self, source: str, streams: Streams) -> str:
        """`$(source)`: what the commands print, without the newlines at the end."""
        captured = Captured()
        inner = self.clone()
        inner_streams = Streams(streams.stdin.fork(), captured, streams.stderr)
        program = self._start(["$()"], subshell_main(inner, lambda: inner.run(source, inner_streams)), inner_streams)
        job = Job([program], source, inner_streams.stdin)
        await self._wait_front(job)
        self.status = self._substitution_status = job.status
        if job.interrupted:
            raise Interrupted
        if captured.is_cut:
            streams.stderr.write(
                f"{self.name}: warning: command substitution: more than {CAPTURE_LIMIT >> 20} MB of output, the rest is lost\n"
            )
        return captured.text.rstrip("\n")

    async def _and_or(self, node: syntax.AndOr, streams: Streams) -> None:
        if node.background:
            try:
                await self._background(node, streams)
            except SyntaxProblem as problem:
                streams.stderr.write(f"{self.name}: {problem}\n")
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
                await self._pipeline(pipeline, streams)
            except SyntaxProblem as problem:
                streams.stderr.write(f"{self.name}: {problem}\n")
                self.status = 1
                if isinstance(problem, UnboundProblem) and not self.interactive:
                    raise ExitShell(self.unbound_status) from None
                if isinstance(problem, ExpansionProblem):
                    raise DiscardLine from None
            finally:
                self.condition_depth -= asked
        if "e" in self.options and self.status and not last.negated and not self.condition_depth:
            raise ExitShell(self.status)

    async def _background(self, node: syntax.AndOr, streams: Streams) -> None:
        stdin = streams.stdin.fork() if self.interactive else InputStream()
        streams = replace(streams, stdin=stdin)
        inner = self.clone()
        inner.background = True
        inner.unbound_status = self.unbound_status
        if len(node.items) == 1 and not node.items[0][1].negated:
            programs = inner._start_stages(node.items[0][1], streams)
        else:
            foreground = replace(node, background=False)
            main = subshell_main(inner, lambda: inner.run_tree(syntax.Sequence([foreground]), streams))
            programs = [inner._start([node.source], main, streams)]
        job = Job(programs, node.source, stdin)
        self.jobs.add(job)
        self.last_background = programs[-1].pid
        self.status = 0
        if self.interactive:
            streams.stderr.write(f"[{job.number}] {programs[-1].pid}\n")

    async def _timed(self, node: syntax.Pipeline, streams: Streams) -> None:
        """`time …`: how long it really took, and what the processor did meanwhile."""
        began, before = self.desk.clock.wall_ns(), os.times()
        try:
            await self._pipeline(replace(node, timed=False), streams)
        finally:
            after = os.times()
            user = after.user + after.children_user - before.user - before.children_user
            system = after.system + after.children_system - before.system - before.children_system
            seconds = (self.desk.clock.wall_ns() - began) / 1e9
            for name, value in (("\nreal", seconds), ("user", user), ("sys", system)):
                streams.stderr.write(f"{name}\t{int(value // 60)}m{value % 60:.3f}s\n")

    async def _pipeline(self, node: syntax.Pipeline, streams: Streams) -> None:
        if node.timed:
            await self._timed(node, streams)
            return
        if self._interrupted:
            streams.stderr.write("\n")
            raise Interrupted
        command = node.commands[0]
        if len(node.commands) > 1:
            front = replace(streams, stdin=streams.stdin.fork())
            programs, printed = self._start_stages(node, front), Printed(front.stdin)
            await self._foreground(Job(programs, node.source, front.stdin), streams)
            missing = next((program for program in programs if program.status == NOT_FOUND), None)
            if missing is not None and self.interactive and streams.stderr.isatty():
                streams.stderr.write(await hint_below_command(self, missing.session.argv, printed, NOT_FOUND))
        elif isinstance(command, syntax.SimpleCommand):
            await self._simple(command, node.source, streams)
        else:
            await run_compound(self, command, streams)
        if node.negated:
            self.status = 0 if self.status else 1

    def _start_stages(self, node: syntax.Pipeline, streams: Streams) -> list[Program]:
        """Start every command of a pipeline in a copy of the shell, each writing into the next."""
        programs: list[Program] = []
        stdin = streams.stdin
        for index, command in enumerate(node.commands):
            last = index == len(node.commands) - 1
            pipe = None if last else Pipe()
            stage = Streams(stdin, streams.stdout if pipe is None else pipe.writer, streams.stderr)
            try:
                program = self._start([node.source], self._stage_main(command, stage), stage)
            except (
                SyntaxProblem
            ):  # too many programs: those already started would be in no job, and Ctrl-C would not reach them
                for started in programs:
                    started.kill()
                raise
            if index:
                program.session.defer(stdin.close)
            if pipe is not None:
                program.session.defer(pipe.writer.close)
                stdin = pipe.reader
            programs.append(program)
        return programs

    def _stage_main(self, command: syntax.Command, streams: Streams) -> Main:
        inner = self.clone()
        if not isinstance(command, syntax.SimpleCommand):
            return subshell_main(inner, lambda: run_compound(inner, command, streams))

        async def become(session: Session) -> int:
            try:
                prepared = await inner._prepare(command, streams)
            except SyntaxProblem as problem:
                session.print_error(f"{inner.name}: {problem}")
                return self.unbound_status if isinstance(problem, UnboundProblem) else 1
            if prepared is None:
                return 1
            session.host = inner
            session.env = prepared.env
            session.cwd = inner.cwd
            session.stdin, session.stdout, session.stderr = (
                prepared.streams.stdin,
                prepared.streams.stdout,
                prepared.streams.stderr,
            )
            session.defer(prepared.opened.close)
            return await session.execute(prepared.main, prepared.argv)

        return become

    # -- simple commands -----------------------------------------------------------------------------------------------

    async def _simple(self, command: syntax.SimpleCommand, source: str, streams: Streams) -> None:
        tty = streams.stdin.fork()
        prepared = await self._prepare(command, replace(streams, stdin=tty))
        if prepared is None:
            self.status = 1
            return
        if not prepared.argv:
            prepared.opened.close()
            return
        program = self._start(prepared.argv, prepared.main, prepared.streams, env=prepared.env, shell=self)
        program.session.defer(prepared.opened.close)
        printed = Printed(tty)
        await self._foreground(Job([program], source, tty), streams)
        if self.status and self.interactive and prepared.streams.stderr.isatty():
            prepared.streams.stderr.write(await hint_below_command(self, prepared.argv, printed, self.status))
        if (end := self.wanted.pop(program.session, None)) is not None:
            raise end

    async def _prepare(self, command: syntax.SimpleCommand, streams: Streams) -> _Prepared | None:
        """Expand the words, open the redirections, find the command. None (and a message) if a redirection failed."""
        from day6_core.shell.commands import find_command, list_too_long, too_long

        self._substitution_status = 0
        argv = await expand(command.words, self, streams)
        values = [await self._assigned(name, word, streams) for name, word in command.assignments]
        if "x" in self.options:
            shown = [*(f"{name}={value}" for name, value in values), *argv]
            streams.stderr.write("+ " + " ".join(shown) + "\n")
        opened = ExitStack()
        try:
            redirected = await redirect(command.redirections, self, streams, opened)
        except OSError as error:
            opened.close()
            streams.stderr.write(f"{self.name}: {error.filename}: {error.strerror}\n")
            return None
        env = self.environment
        if argv:
            env.update(values)
        else:
            self.variables.update(values)
            self.status = self._substitution_status
        main = find_command(argv[0], self) if argv else _nothing
        if argv and argv[0] not in self.functions and too_long(argv, env):
            main = list_too_long(argv[0], self)
        return _Prepared(argv, main, redirected, env, opened)

    async def _assigned(self, name: str, word: Word, streams: Streams) -> tuple[str, str]:
        value = await expand_text(word, self, streams, assigned=True)
        plain = name.removesuffix("+")
        if plain != name:
            value = self.variables.get(plain, "") + value
        if len(value) > LONGEST_VALUE:
            streams.stderr.write(f"{self.name}: xrealloc: cannot allocate {len(value)} bytes\n")
            raise ExitShell(2)
        return plain, value

    # -- programs and jobs ---------------------------------------------------------------------------------------------

    def _start(
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
        self, inner: Shell, run: Callable[[], Awaitable[int]], inner_streams: Streams, streams: Streams
    ) -> None:
        """Run `( … )`: `run()` does its work in the copy `inner`, which has the terminal until it ends."""
        program = self._start(["( )"], subshell_main(inner, run), inner_streams)
        await self._foreground(Job([program], "( )", inner_streams.stdin), streams)

    async def _foreground(self, job: Job, streams: Streams) -> None:
        """Give the job the terminal until it ends or is stopped, and take its status."""
        await self._wait_front(job)
        self._after(job, streams)

    async def _wait_front(self, job: Job) -> None:
        self._front.append(job)
        job.tty.focus()
        try:
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
            self.jobs.add(job)
            streams.stderr.write(f"\n{self.jobs.line(job)}\n")
            self.status = 148
            return
        self.jobs.remove(job)
        self.status = job.status
        if job.killed_by not in (0, 2, 13):
            streams.stderr.write(f"{job.state}\n")
        if job.interrupted:
            if self.interactive:
                streams.stderr.write("\n")
            raise Interrupted

    async def resume_in_front(self, job: Job, streams: Streams) -> int:
        """`fg`: continue the job here and wait for it."""
        streams.stdout.write(f"{job.source}\n")
        job.resume()
        await self._foreground(job, streams)
        return self.status


@dataclass
class _Prepared:
    argv: list[str]
    main: Main
    streams: Streams
    env: dict[str, str]
    opened: ExitStack


async def _nothing(session: Session) -> int:
    return 0


def shell_of(session: Session) -> Shell:
    """The shell that runs a built-in. Raises LookupError for a program that no shell has started."""
    if not isinstance(session.host, Shell):
        raise LookupError(f"{session.name}: no shell")
    return session.host


def write_error(session: Session, error: OSError) -> int:
    """Report that a command's output could not be written, as bash does for its built-ins; return the status."""
    from day6_core.shell.commands import SHELL_BUILTINS

    if not isinstance(session.host, Shell) or session.name not in SHELL_BUILTINS:
        return report_write_error(session, error)
    session.print_error(f"{session.host.name}: {session.name}: write error: {error.strerror}")
    return 1


def subshell_main(inner: Shell, run: Callable[[], Awaitable[int]]) -> Main:
    """The program of a subshell: `run()` is the coroutine that does its work in the copy `inner`."""

    async def main(session: Session) -> int:
        def on_stop(stopped: bool) -> None:
            if inner.front is not None and stopped:
                inner.front.stop()
            elif inner.front is not None:
                inner.front.resume()

        session.on_interrupt = inner.interrupt
        session.on_stop = on_stop
        if inner.depth > MAX_DEPTH:
            session.print_error(inner.too_deep)
            return 1
        try:
            return await run()
        except ExitShell as end:
            return end.status
        except Interrupted:
            raise KeyboardInterrupt from None
        except (LoopControl, ReturnFromSource, DiscardLine):
            return inner.status
        finally:
            for job in inner.jobs.jobs:
                job.send(15)

    return main
