"""A small stepped machine that runs `ros2`: no wall clock, no link, no process."""

from __future__ import annotations

import itertools
import os
import threading
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any, NamedTuple

from day6_core.graph import Graph
from day6_core.ros import ros2
from day6_core.ros.programs import load
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display, ProgramDisplay
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured, InputStream, TextInput
from day6_core.session.task import Signal, wait_for

LONGEST = 30.0
"""Seconds of the wall that a command's thread may work."""


def _work_is_done() -> bool:
    """Wait for what commands do in threads (`day6_core/session/threads.py`): the stepped clock does not. False without any."""
    working = [thread for thread in threading.enumerate() if thread.name == "day6-work"]
    for thread in working:
        thread.join(LONGEST)
    return bool(working)


class Result(NamedTuple):
    stdout: str
    stderr: str
    status: int | None


class IdleKeyboard(InputStream):
    """A terminal at which nobody types."""

    def isatty(self) -> bool:
        return True

    async def read_key(self) -> str:
        await wait_for(Signal(), None)
        return ""


class Command:
    """A `ros2` command that runs; `step` lets world time pass."""

    def __init__(self, machine: Machine, session: Session, program: Program) -> None:
        self.machine = machine
        self.session = session
        self.program = program

    @property
    def stdout(self) -> str:
        return self.session.stdout.text.replace(os.sep, "/")  # as it was recorded

    @property
    def stderr(self) -> str:
        return self.session.stderr.text.replace(os.sep, "/")

    @property
    def status(self) -> int | None:
        return self.program.status

    def step(self, seconds: float = 0.0) -> None:
        self.machine.step(seconds)

    def interrupt(self) -> None:
        self.session.interrupt()
        self.machine.step()


class NoPrograms:
    """A shell of day6-tui that starts nothing beside a command."""

    starts_programs = False
    terminals = ()

    def becomes(self, session: Session, before: list[str]) -> None:
        """Nobody keeps what is run."""


class Machine:
    """One graph and one stepped clock. `daemon`: whether commands find a daemon, as in the desktop."""

    def __init__(self, cwd: Path) -> None:
        self.graph = Graph()
        self.clock = WorldClock(wall=None)
        self.graph.now_ns = self.clock.now_ns
        self.scheduler = Scheduler(self.clock)
        self.cwd = cwd
        self.daemon = False
        self.env = {"COLUMNS": "80"}
        self.python: Callable[[Session, list[str]], Awaitable[int]] | None = None
        """What `session.run_python` does, if a test lets commands start processes."""
        self._pids = itertools.count(100)

    def step(self, seconds: float = 0.0) -> None:
        self.scheduler.advance(seconds)
        if _work_is_done():
            self.scheduler.advance(0.0)

    def session(self, argv: list[str], stdin: str = "") -> Session:
        session = Session(
            self.scheduler,
            self.graph,
            argv,
            env=dict(self.env),
            cwd=self.cwd,
            pid=next(self._pids),
            stdin=TextInput(stdin),
            stdout=Captured(),
            stderr=Captured(),
        )
        session.host = NoPrograms() if self.daemon else None
        session.python = self.python
        return session

    def start(self, *words: str, stdin: str = "") -> Command:
        """Start `ros2 WORDS…` and let it do what it can at this moment."""
        session = self.session(["ros2", *words], stdin)
        command = Command(self, session, Program(session, ros2.main))
        self.step()
        return command

    def ros2(self, *words: str, stdin: str = "", seconds: float = 30.0) -> Result:
        """Run `ros2 WORDS…` to its end, for at most so many world seconds."""
        command = self.start(*words, stdin=stdin)
        passed = 0.0
        while command.status is None and passed < seconds:
            self.step(0.05)
            passed += 0.05
        return Result(command.stdout, command.stderr, command.status)

    def complete(self, *words: str) -> list[str]:
        """The Tab completions of a line whose last word is the last of `words`."""
        found: list[str] = []

        async def complete(session: Session) -> None:
            found.extend(await ros2.complete(["ros2", *words], session))

        self.program(complete)
        return found

    def node(self, name: str, build: Callable[[Any], object] | None = None, **keywords: Any) -> Any:
        """Let a node run: `build(node)` gives it what it has."""
        made = []

        async def main(session: Session) -> None:
            node = session.create_node(name, cli_args=[], **keywords)
            made.append(node)
            if build is not None:
                build(node)
            await session.spin(node)

        self.program(main)
        return made[0]

    def run(
        self,
        package: str,
        executable: str,
        *args: str,
        stdin: InputStream | None = None,
        display: Display | None = None,
    ) -> Session:
        """Start an executable of ours, as `ros2 run` does; returns its session."""
        session = self.session([executable, *args])
        session.display = None if display is None else ProgramDisplay(display, session.interrupt)
        if stdin is not None:
            session.stdin = stdin
        Program(session, load(package, executable))
        self.step()
        return session

    def program(self, main) -> Session:
        """Run another program on the same machine: `main(session)`."""
        session = self.session(["program"])
        Program(session, main)
        self.step()
        return session
