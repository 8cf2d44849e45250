"""A simulated machine without a screen, whose time the test steps."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from day6_core.session.clock import WorldClock
from day6_core.session.program import Program
from day6_core.session.session import Session
from day6_core.session.streams import Captured, TextInput
from day6_core.shell.desk import Desk
from day6_core.shell.language.interpreter import Shell
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.subshells import whole_run
from day6_core.shell.terminal import Terminal
from tests.support.waiting import until


class Result(NamedTuple):
    status: int
    out: str
    err: str


def show_all(terminal: Terminal) -> set[int]:
    """Let a terminal show all that was written, for which one `update` may have no time; return the lines that changed."""
    changed: set[int] = set()
    while terminal.has_more:
        changed |= terminal.update()
    return changed


class Machine:
    """Runs command lines as `day6-tui exec` does."""

    def __init__(self, home: Path) -> None:
        self.desk = Desk(
            home, domain_id=0, join_link=False, clock=WorldClock(wall=None, epoch_ns=1_700_000_000_000_000_000)
        )
        self.shell: Shell = self.desk.shell()
        self.out, self.err = Captured(), Captured()

    def start(self, commands: str, stdin: str = "") -> Program:
        """Start a script; what it prints is in `out` and `err`."""
        self.out, self.err = Captured(), Captured()
        streams = Streams(TextInput(stdin), self.out, self.err)
        shell = self.shell

        async def script(session: Session) -> int:
            session.on_interrupt = shell.interrupt
            return await whole_run(shell, lambda: shell.run(commands, streams), streams)

        program = self.desk.start_program(["bash"], script, streams, env=shell.environment, cwd=shell.cwd, shell=shell)
        self.desk.scheduler.advance()
        return program

    def go(self, seconds: float = 0.0) -> None:
        self.desk.scheduler.advance(seconds)

    def wait(self, condition: Callable[[], bool]) -> None:
        """Let real processes work until the condition holds."""
        until(
            lambda: self.desk.scheduler.run(condition, 0.01),
            every=0.0,
            told=lambda: f"{self.out.text}\n{self.err.text}",
        )

    def run(self, commands: str, stdin: str = "", seconds: float = 0.0) -> Result:
        """Run a script to its end, stepping the world by `seconds`."""
        program = self.start(commands, stdin)
        if seconds:
            self.go(seconds)
        self.wait(lambda: program.status is not None)
        assert program.status is not None
        return Result(program.status, self.out.text, self.err.text)


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    made = Machine(tmp_path / "home")
    yield made
    made.desk.close()


class Seat:
    """Somebody at a terminal: types and looks."""

    def __init__(self, desk: Desk, columns: int = 80, rows: int = 24) -> None:
        self.desk = desk
        self.terminal: Terminal = desk.open_terminal(columns, rows)
        self.settle()

    def settle(self, seconds: float = 0.0) -> None:
        self.desk.scheduler.advance(seconds)
        self.look()

    def look(self) -> str:
        """The screen as text."""
        while self.terminal.has_more:
            self.terminal.update()
            self.desk.scheduler.advance()
        return self.terminal.screen.text

    def type(self, text: str, seconds: float = 0.0) -> str:
        """Type keys, let the world go on, return the screen."""
        self.terminal.send(text)
        self.settle(seconds)
        return self.look()

    def line(self, text: str, seconds: float = 0.0) -> str:
        """Type a command and Enter."""
        return self.type(text + "\r", seconds)

    def wait(self, condition: Callable[[str], bool]) -> str:
        """Let real processes work until the screen is as expected."""
        seen = ""

        def holds() -> bool:
            nonlocal seen
            self.terminal.update()
            seen = self.terminal.screen.text
            return condition(seen)

        until(lambda: self.desk.scheduler.run(holds, 0.01), every=0.0, told=lambda: seen)
        return seen

    def wait_prompt(self) -> str:
        """Wait until the prompt is back."""
        return self.wait(lambda text: self.terminal.idle and not self.terminal.has_more)


@pytest.fixture
def seat(machine: Machine) -> Seat:
    return Seat(machine.desk)


@pytest.fixture
def seat_at() -> type[Seat]:
    """Opens a terminal of another desk."""
    return Seat
