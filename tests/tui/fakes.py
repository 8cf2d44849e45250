"""A machine that does nothing by itself: real display, graph and clock, terminals that show what the test writes."""

from __future__ import annotations

from collections import deque
from types import SimpleNamespace
from typing import Any

import pyte

from day6_tui.core.graph.graph import Graph
from day6_tui.core.ros.programs.turtlesim.model.trail import Trail
from day6_tui.core.session.clock import WorldClock
from day6_tui.core.session.display import Display


class FakeTerminal:
    """A terminal without a shell: `write` is what a program prints, `sent` what the user typed."""

    def __init__(self, columns: int, rows: int, title: str = "") -> None:
        self.screen = pyte.HistoryScreen(columns, rows, history=1000)
        self.screen.dirty.clear()
        self._stream = pyte.Stream(self.screen)
        self.sent = ""
        self.title = title
        self.reading_keys = False
        self.idle = True
        self.closed = False
        self.application_cursor = False
        self.bracketed_paste = False
        self._printed = False

    @property
    def history(self) -> deque[Any]:
        return self.screen.history.top

    def write(self, text: str) -> None:
        self._stream.feed(text.replace("\n", "\r\n"))
        self._printed = True

    def send(self, text: str) -> None:
        self.sent += text

    def update(self) -> bool:
        printed, self._printed = self._printed, False
        return printed

    def resize(self, columns: int, rows: int) -> None:
        self.screen.resize(rows, columns)
        self.screen.dirty.update(range(rows))

    def clear_history(self) -> None:
        self.screen.history.top.clear()

    def hang_up(self) -> None:
        self.closed = True


class FakeDesk:
    """What the application uses of a desk."""

    def __init__(self) -> None:
        self.display = Display()
        self.graph = Graph(0)
        self.clock = WorldClock(wall=None, epoch_ns=0)
        self.clock._paused = False
        self.scheduler = SimpleNamespace(on_activity=None)
        self.terminals: list[FakeTerminal] = []
        self.steps: list[float] = []

    def open_terminal(self, columns: int, rows: int) -> FakeTerminal:
        terminal = FakeTerminal(columns, rows, title="bash")
        terminal.write("student@day6:~$ ")
        self.terminals.append(terminal)
        return terminal

    def pause(self) -> None:
        self.clock._paused = True

    def resume(self) -> None:
        self.clock._paused = False

    def step(self, seconds: float) -> None:
        self.steps.append(seconds)

    def set_speed(self, factor: float) -> None:
        self.clock.set_speed(factor)


def turtle(name: str = "turtle1", x: float = 5.544445, y: float = 5.544445, theta: float = 0.0, v: float = 0.0) -> Any:
    return SimpleNamespace(name=name, kind="jazzy", x=x, y=y, theta=theta, linear_velocity=v, angular_velocity=0.0)


class FakeSimulation:
    """A turtlesim model whose scene the test sets."""

    def __init__(self, *turtles: Any, background: tuple[int, int, int] = (69, 86, 255)) -> None:
        self.node_name = "/turtlesim"
        self.trail = Trail()
        self.background = background
        self.scene = SimpleNamespace(turtles=turtles or (turtle(),), background=background)

    def show(self, *turtles: Any) -> None:
        self.scene = SimpleNamespace(turtles=turtles, background=self.background)
