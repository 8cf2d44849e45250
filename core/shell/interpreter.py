"""Runs parsed command lines: pipelines, lists, redirections, variables, background jobs.

A `Shell` is the state of one shell. Every simple command, built-in or not, runs as a program of its own with a session (so
Ctrl-C, pipes and `timeout` need no special cases); built-ins that change the shell reach it as `session.shell`. Commands in a
pipeline, in `( )` and in the background work on a copy.
"""

from __future__ import annotations

import os
from collections.abc import Awaitable, Callable
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from day6_tui.core.session.program import Program
from day6_tui.core.session.session import Main, Session
from day6_tui.core.session.streams import Captured, InputStream, Pipe
from day6_tui.core.shell import syntax
from day6_tui.core.shell.control_flow import ExitShell, Interrupted, LoopControl, ReturnFromSource
from day6_tui.core.shell.expansion import expand, expand_text
from day6_tui.core.shell.jobs import Job, JobTable
from day6_tui.core.shell.lexer import SyntaxProblem
from day6_tui.core.shell.redirection import Streams, redirect

if TYPE_CHECKING:
    from day6_tui.core.shell.desk import Desk

MAX_DEPTH = 100
"""How deep `source`, `( )` and `$( )` may nest, so that a file that sources itself ends with a message."""


class Shell:
    """One shell: variables, working directory, jobs. `name` stands before its messages (`bash: …`)."""

    def __init__(self, desk: Desk, *, env: dict[str, str], cwd: Path, interactive: bool, name: str = "bash") -> None:
        self.desk = desk
        self.variables = env
        self.exported = set(env)
        self.cwd = cwd
        self.interactive = interactive
        self.name = name
        self.zero = name
        """What `$0` is: the name of the script being run."""
        self.arguments: list[str] = []
        self.options: set[str] = set()
        """Of `set`: 'e' ends the shell at the first failing command, 'x' shows each command."""
        self.status = 0
        self.pid = desk.new_pid()
        self.last_background = 0
        self.jobs = JobTable()
        self.history: list[str] = []
        self.depth = 0
        self.subshell = False
        self.background = False
        """Whether it runs a job that was started with `&`."""
        self._substitution_status = 0
        """Status of the last `$(…)` in the command being prepared: that of an assignment is this one's."""
        self._front: list[Job] = []
        """Jobs being waited for, the innermost last."""

    # -- what others ask -----------------------------------------------------------------------------------------------

    @property
    def environment(self) -> dict[str, str]:
        """The exported variables: what a program started here gets."""
        return {name: value for name, value in self.variables.items() if name in self.exported}

    @property
    def front(self) -> Job | None:
        """The job that has the terminal now."""
        return self._front[-1] if self._front else None

    @property
    def short_cwd(self) -> str:
        """The working directory with `~` for the home folder."""
        home = self.variables.get("HOME", "")
        cwd = str(self.cwd)
        if home and (cwd == home or cwd.startswith(home + os.sep)):
            return "~" + cwd[len(home) :]
        return cwd

    def parameter(self, name: str) -> str | None:
        """The value of `$name`, special parameters included; None if it is not set."""
        special: dict[str, Callable[[], str]] = {
            "?": lambda: str(self.status),
            "$": lambda: str(self.pid),
            "!": lambda: str(self.last_background) if self.last_background else "",
            "#": lambda: str(len(self.arguments)),
            "@": lambda: " ".join(self.arguments),
            "*": lambda: " ".join(self.arguments),
            "-": lambda: "hiB" if self.interactive else "hB",
            "0": lambda: self.zero,
        }
        if name in special:
            return special[name]()
        if name.isdigit():
            index = int(name)
            return self.arguments[index - 1] if index <= len(self.arguments) else None
        return self.variables.get(name)

    def interrupt(self) -> bool:
        """Ctrl-C for the innermost foreground job; False if there is none."""
        front = self.front
        if front is None:
            return False
        front.interrupt()
        return True

    def suspend(self) -> bool:
        """Ctrl-Z for the foreground job."""
        front = self.front
        if front is None:
            return False
        front.stop()
        return True

    @property
    def too_deep(self) -> str:
        return f"{self.name}: maximum nesting level exceeded ({MAX_DEPTH})"

    def clone(self) -> Shell:
        """A copy for a subshell: changes to it do not come back, and it has no jobs."""
        twin = Shell(self.desk, env=dict(self.variables), cwd=self.cwd, interactive=False, name=self.name)
        twin.exported = set(self.exported)
        twin.arguments = list(self.arguments)
        twin.zero = self.zero
        twin.options = set(self.options)
        twin.status = self.status
        twin.pid = self.pid
        twin.last_background = self.last_background
        twin.history = self.history
        twin.depth = self.depth + 1
        twin.subshell = True
        twin.background = self.background
        return twin

    # -- running -------------------------------------------------------------------------------------------------------

    async def run(self, source: str, streams: Streams) -> int:
        """Run command lines; messages about wrong ones go to `streams.stderr`. Returns the last status.

        Raises ExitShell, and LoopControl or ReturnFromSource where those built-ins were used.
        """
        try:
            tree = syntax.parse(source)
        except SyntaxProblem as problem:
            streams.stderr.write(f"{self.name}: {problem}\n")
            self.status = 2
            return 2
        return await self.run_tree(tree, streams)

    async def run_line(self, source: str, session: Session) -> int:
        """Run command lines for a program, on its streams; for commands that start others (`ros2 run --prefix`)."""
        return await self.run(source, Streams(session.stdin, session.stdout, session.stderr))

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
        return captured.text.rstrip("\n")

    async def _and_or(self, node: syntax.AndOr, streams: Streams) -> None:
        if node.background:
            try:
                await self._background(node, streams)
            except SyntaxProblem as problem:
                streams.stderr.write(f"{self.name}: {problem}\n")
                self.status = 1
            return
        for index, (operator, pipeline) in enumerate(node.items):
            if index and (self.status == 0) != (operator == "&&"):
                continue
            try:
                await self._pipeline(pipeline, streams)
            except SyntaxProblem as problem:
                streams.stderr.write(f"{self.name}: {problem}\n")
                self.status = 1
        last_ran = node.items[-1][1]
        if "e" in self.options and self.status and not last_ran.negated and not self._condition_depth:
            raise ExitShell(self.status)

    _condition_depth = 0
    """Inside the condition of `if` and `while`, where `set -e` does not apply."""

    async def _background(self, node: syntax.AndOr, streams: Streams) -> None:
        stdin = streams.stdin.fork() if self.interactive else InputStream()
        streams = replace(streams, stdin=stdin)
        inner = self.clone()
        inner.background = True
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

    async def _pipeline(self, node: syntax.Pipeline, streams: Streams) -> None:
        command = node.commands[0]
        if len(node.commands) > 1:
            front = replace(streams, stdin=streams.stdin.fork())
            await self._foreground(Job(self._start_stages(node, front), node.source, front.stdin), streams)
        elif isinstance(command, syntax.Simple):
            await self._simple(command, node.source, streams)
        else:
            await self._compound(command, streams)
        if node.negated:
            self.status = 0 if self.status else 1

    def _start_stages(self, node: syntax.Pipeline, streams: Streams) -> list[Program]:
        """Start every command of a pipeline in a copy of the shell, each writing into the next."""
        programs = []
        stdin = streams.stdin
        for index, command in enumerate(node.commands):
            last = index == len(node.commands) - 1
            pipe = None if last else Pipe()
            stage = Streams(stdin, streams.stdout if pipe is None else pipe.writer, streams.stderr)
            program = self._start([node.source], self._stage_main(command, stage), stage)
            if index:
                program.session.defer(stdin.close)
            if pipe is not None:
                program.session.defer(pipe.writer.close)
                stdin = pipe.reader
            programs.append(program)
        return programs

    def _stage_main(self, command: syntax.Command, streams: Streams) -> Main:
        inner = self.clone()
        if not isinstance(command, syntax.Simple):
            return subshell_main(inner, lambda: inner._compound_status(command, streams))

        async def become(session: Session) -> int:
            try:
                prepared = await inner._prepare(command, streams)
            except SyntaxProblem as problem:
                session.print_error(f"{inner.name}: {problem}")
                return 1
            if prepared is None:
                return 1
            session.shell = inner
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

    async def _simple(self, command: syntax.Simple, source: str, streams: Streams) -> None:
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
        await self._foreground(Job([program], source, tty), streams)
        end = program.session.shell_end
        if isinstance(end, Exception):
            raise end

    async def _prepare(self, command: syntax.Simple, streams: Streams) -> _Prepared | None:
        """Expand the words, open the redirections, find the command. None (and a message) if a redirection failed."""
        from day6_tui.core.shell.commands import find_command

        self._substitution_status = 0
        argv = await expand(command.words, self, streams)
        if argv and argv[0] in self.aliases and command.words[0].plain == argv[0]:
            argv = [*self.aliases[argv[0]], *argv[1:]]
        values = [(name, await expand_text(word, self, streams)) for name, word in command.assignments]
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
        return _Prepared(argv, main, redirected, env, opened)

    # -- compound commands ---------------------------------------------------------------------------------------------

    async def _compound_status(self, command: syntax.Command, streams: Streams) -> int:
        await self._compound(command, streams)
        return self.status

    async def _compound(self, command: syntax.Command, streams: Streams) -> None:
        assert not isinstance(command, syntax.Simple)
        with ExitStack() as opened:
            try:
                streams = await redirect(command.redirections, self, streams, opened)
            except OSError as error:
                streams.stderr.write(f"{self.name}: {error.filename}: {error.strerror}\n")
                self.status = 1
                return
            if isinstance(command, syntax.Group):
                await self._group(command, streams)
            elif isinstance(command, syntax.If):
                await self._if(command, streams)
            else:
                await self._loop(command, streams)

    async def _group(self, command: syntax.Group, streams: Streams) -> None:
        if not command.subshell:
            await self.run_tree(command.body, streams)
            return
        inner = self.clone()
        front = replace(streams, stdin=streams.stdin.fork())
        main = subshell_main(inner, lambda: inner.run_tree(command.body, front))
        await self._foreground(Job([self._start(["( )"], main, front)], "( )", front.stdin), streams)

    async def _if(self, command: syntax.If, streams: Streams) -> None:
        for condition, body in command.branches:
            if await self._holds(condition, streams):
                await self.run_tree(body, streams)
                return
        self.status = 0
        if command.otherwise is not None:
            await self.run_tree(command.otherwise, streams)

    async def _holds(self, condition: syntax.Sequence, streams: Streams) -> bool:
        self._condition_depth += 1
        try:
            return await self.run_tree(condition, streams) == 0
        finally:
            self._condition_depth -= 1

    async def _loop(self, command: syntax.For | syntax.While, streams: Streams) -> None:
        from day6_tui.core.session.scheduler import let_others_run

        values: list[str] | None = None
        if isinstance(command, syntax.For):
            values = list(self.arguments) if command.words is None else await expand(command.words, self, streams)
        status = 0
        while True:
            if isinstance(command, syntax.For):
                if not values:
                    break
                self.variables[command.name] = values.pop(0)
            elif await self._holds(command.condition, streams) == command.until:
                break
            await let_others_run()
            try:
                status = await self.run_tree(command.body, streams)
            except LoopControl as control:
                if control.levels > 1:
                    raise LoopControl(control.levels - 1, control.again) from None
                status = 0
                if not control.again:
                    break
        self.status = status

    # -- programs and jobs ---------------------------------------------------------------------------------------------

    aliases: dict[str, list[str]] = {"ll": ["ls", "-alF"], "la": ["ls", "-A"], "l": ["ls", "-CF"]}
    """What Ubuntu's .bashrc defines."""

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
        return program

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
            # The shell itself is being ended (a subshell in a pipeline, a closed terminal): nothing it started stays.
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
        except (LoopControl, ReturnFromSource):
            return inner.status
        finally:
            for job in inner.jobs.jobs:
                job.send(15)

    return main
