"""A machine whose time the test moves on: it runs executables of our packages, and watches with a node of its own."""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

from day6_core.graph import Graph
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured, InputStream
from tests.support.waiting import PATIENCE, until

EPOCH_NS = 1_700_000_000_000_000_000
STEP = 0.01
"""Seconds the machine moves on at a time while it waits for an answer."""


class Running:
    """A started program with what it wrote."""

    def __init__(self, program: Program, stdout: Captured, stderr: Captured) -> None:
        self.program = program
        self._stdout = stdout
        self._stderr = stderr

    @property
    def output(self) -> str:
        return self._stdout.text

    @property
    def errors(self) -> str:
        """What it wrote to stderr, without the time stamps of its log."""
        return re.sub(r" \[17\d+\.\d{9}\]", "", self._stderr.text)

    @property
    def log(self) -> list[str]:
        """The lines of that."""
        return self.errors.splitlines()


class SteppedMachine:
    """One graph, one clock that stands still between calls of `advance`, and `node`, the test's own."""

    WHILE_WAITING = 0.01
    """Seconds."""

    def __init__(self, clock: WorldClock | None = None) -> None:
        self.clock = WorldClock(wall=None, epoch_ns=EPOCH_NS) if clock is None else clock
        self.scheduler = Scheduler(self.clock)
        self.graph = Graph()
        self.display = Display()
        self._programs: list[Program] = []
        session = Session(self.scheduler, self.graph, ["watcher"])
        self.node = session.create_node("watcher")
        self._programs.append(Program(session, lambda session: session.spin(self.node)))

    def start(
        self,
        package: str,
        executable: str,
        *args: str,
        stdin: InputStream | None = None,
        screen: bool = False,
        background: bool = False,
        home: Path | None = None,
    ) -> Running:
        """Run an executable up to its first wait; `background`: as a launch does; `home` is its folder, too."""
        stdout, stderr = Captured(), Captured()
        session = Session(
            self.scheduler,
            self.graph,
            [executable, *args],
            stdin=stdin,
            stdout=stdout,
            stderr=stderr,
            display=self.display if screen else None,
            env=None if home is None else {"HOME": str(home)},
            cwd=home,
        )
        session.background = background
        module = importlib.import_module(f"day6_core.ros.programs.{package}.{executable}")
        program = Program(session, module.main)
        self._programs.append(program)
        self.advance()
        return Running(program, stdout, stderr)

    def advance(self, seconds: float = 0.0) -> None:
        self.scheduler.advance(seconds)

    def until(self, condition: Callable[[], object], limit: float = PATIENCE) -> None:
        """Wait in real time for what a thread does; the machine's time goes on by WHILE_WAITING with every look."""
        until(condition, limit, every=0.002, meanwhile=lambda: self.advance(self.WHILE_WAITING))

    def wait(self, future: Any, seconds: float = 4.0, step: float = STEP) -> Any:
        """Move on until the future is done; return its result."""
        for _ in range(round(seconds / step)):
            if future.done():
                return future.result()
            self.advance(step)
        raise AssertionError("no answer")

    def call(self, service: Any, to: str, /, **fields: Any) -> Any:
        """Call a service and return its response."""
        return self.wait(self.node.create_client(service, to).call_async(service.Request(**fields)))

    def watch(self, message: type, topic: str, qos: Any = 10) -> list[Any]:
        """Return a list that fills with the messages of a topic."""
        seen: list[Any] = []
        self.node.create_subscription(message, topic, seen.append, qos)
        self.advance()
        return seen

    def end(self) -> None:
        """Kill what still runs."""
        for program in self._programs:
            program.kill()
        self.advance()
