"""A machine that does nothing by itself: real display, graph and clock, terminals that show what the test writes."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

from day6_core.graph.graph import Graph
from day6_core.ros.programs.turtlesim.model.trail import Trail
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.shell.runs import Runs
from day6_core.shell.screen.screen import Screen


class FakeTerminal:
    """A terminal without a shell: `write` is what a program prints, `sent` what the user typed."""

    def __init__(self, columns: int, rows: int, title: str = "") -> None:
        self.screen = Screen(columns, rows)
        self.screen.dirty.clear()
        self.sent = ""
        self.title = title
        self.busy = False
        self.is_stubborn = False
        self.closed = False
        self.has_more = False
        self.is_crowded = False
        self.has_news = False
        self.discipline = SimpleNamespace(front=SimpleNamespace(is_raw=True, receiver=None))
        self.shell = SimpleNamespace(cwd=Path("/"), environment={}, front=None, jobs=SimpleNamespace(jobs=[]))
        self.version = 0
        self.unfinished = ""
        self.runs = Runs()

    @property
    def running(self) -> list[str]:
        return [self.title] if self.busy else []

    @property
    def idle(self) -> bool:
        """Whether nothing stands at the prompt."""
        return not self.busy and (not self.sent or self.sent.endswith("\r"))

    @property
    def columns(self) -> int:
        return self.screen.columns

    @property
    def rows(self) -> int:
        return self.screen.lines

    def write(self, text: str) -> None:
        self.screen.feed(text.replace("\n", "\r\n"))
        self.has_news = True

    def mark_seen(self) -> None:
        self.has_news = False

    def send(self, text: str) -> None:
        self.sent += text

    def paste(self, text: str) -> None:
        self.sent += f"<{text}>"

    def update(self) -> set[int]:
        changed = set(self.screen.dirty)
        self.screen.dirty.clear()
        return changed

    def resize(self, columns: int, rows: int) -> None:
        self.screen.resize(rows, columns)

    def hang_up(self) -> None:
        self.closed = True

    def close(self) -> None:
        self.closed = True


class FakeDesk:
    """What the application uses of a desk."""

    def __init__(self) -> None:
        self.may_change_distribution = False
        self.wanted_distribution = None
        self.display = Display()
        self.graph = Graph(0)
        self.graphs = {0: self.graph}
        self.clock = WorldClock(wall=None, epoch_ns=0)
        self.clock._paused = False
        self.scheduler = SimpleNamespace(on_activity=None)
        self.terminals: list[FakeTerminal] = []
        self.steps: list[float] = []
        self.searching = lambda: ""
        self.home = Path("/dev/null/home")  # nothing can be written there

    def graph_of(self, domain_id: int) -> Graph:
        return self.graph

    def open_terminal(self, columns: int, rows: int, *, cwd: Path | None = None, text: str = "") -> FakeTerminal:
        terminal = FakeTerminal(columns, rows, title="~")
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
        self.topics: dict[str, Any] = {}
        self.background = background
        self.scene = SimpleNamespace(turtles=turtles or (turtle(),), background=background)

    def show(self, *turtles: Any) -> None:
        self.scene = SimpleNamespace(turtles=turtles, background=self.background)
