"""A machine whose time the test moves on: it starts turtlesim's executables and watches with a node of its own."""

from __future__ import annotations

import contextlib
import importlib
import re
from collections import deque
from collections.abc import Iterator
from typing import Any

import pytest

from day6_tui.core.graph import Graph
from day6_tui.core.session.clock import WorldClock
from day6_tui.core.session.display import Display
from day6_tui.core.session.program import Program
from day6_tui.core.session.scheduler import Scheduler, Signal, wait_for
from day6_tui.core.session.session import Session
from day6_tui.core.session.streams import Captured, InputStream

TICK = 0.016
EPOCH_NS = 1_700_000_000_000_000_000


class Keyboard(InputStream):
    """A terminal's keys."""

    def __init__(self) -> None:
        self._keys: deque[str] = deque()
        self._pressed = Signal()
        self.is_raw = False

    def isatty(self) -> bool:
        return True

    def press(self, *keys: str) -> None:
        self._keys.extend(keys)
        self._pressed.set()

    async def read_key(self) -> str:
        while not self._keys:
            self._pressed.clear()
            await wait_for(self._pressed)
        return self._keys.popleft()

    @contextlib.contextmanager
    def raw(self, *, signals: bool = True) -> Iterator[None]:
        assert signals, "Ctrl-C must stay Ctrl-C"
        self.is_raw = True
        try:
            yield
        finally:
            self.is_raw = False


class Running:
    """A started program with its streams."""

    def __init__(self, program: Program, keyboard: Keyboard | None, stdout: Captured, stderr: Captured) -> None:
        self.program = program
        self.keyboard = keyboard
        self._stdout = stdout
        self._stderr = stderr

    @property
    def output(self) -> str:
        return self._stdout.text

    @property
    def log(self) -> list[str]:
        """Its log without the time stamps."""
        return re.sub(r" \[17\d+\.\d{9}\]", "", self._stderr.text).splitlines()


class Machine:
    def __init__(self) -> None:
        clock = WorldClock(wall=None, epoch_ns=EPOCH_NS)
        self.scheduler = Scheduler(clock)
        self.graph = Graph()
        self.display = Display()
        self._programs: list[Program] = []
        session = self._session(["watcher"])
        self.node = session.create_node("watcher")
        self._programs.append(Program(session, lambda session: session.spin(self.node)))

    def _session(self, argv: list[str], **keywords: Any) -> Session:
        return Session(self.scheduler, self.graph, argv, **keywords)

    def start(self, executable: str, *args: str, keyboard: Keyboard | None = None, screen: bool = False) -> Running:
        """Run one of turtlesim's executables up to its first wait."""
        stdout, stderr = Captured(), Captured()
        session = self._session(
            [executable, *args],
            stdin=keyboard,
            stdout=stdout,
            stderr=stderr,
            display=self.display if screen else None,
        )
        module = importlib.import_module(f"day6_tui.core.ros.programs.turtlesim.{executable}")
        program = Program(session, module.main)
        self._programs.append(program)
        self.advance()
        return Running(program, keyboard, stdout, stderr)

    def advance(self, seconds: float = 0.0) -> None:
        self.scheduler.advance(seconds)

    def ticks(self, count: int) -> None:
        self.advance(count * TICK)

    def wait(self, future: Any, ticks: int = 200) -> Any:
        """Move on tick by tick until the future is done; return its result."""
        for _ in range(ticks):
            if future.done():
                return future.result()
            self.ticks(1)
        raise AssertionError("no answer")

    def watch(self, message: type, topic: str) -> list[Any]:
        """Return a list that fills with the messages of a topic."""
        seen: list[Any] = []
        self.node.create_subscription(message, topic, seen.append, 10)
        return seen

    def call(self, service: type, to: str, **fields: Any) -> Any:
        """Call a service and return its response."""
        client = self.node.create_client(service, to)
        return self.wait(client.call_async(service.Request(**fields)))  # type: ignore[attr-defined]

    def topics(self) -> set[str]:
        return {name for name, _ in self.node.get_topic_names_and_types()}

    def end(self) -> None:
        for program in self._programs:
            program.kill()
        self.advance()


@pytest.fixture
def machine() -> Iterator[Machine]:
    machine = Machine()
    yield machine
    machine.end()


@pytest.fixture
def keyboard() -> Keyboard:
    return Keyboard()
