"""A whole machine in which things go wrong for real, and the inspector looking on as after F6."""

from __future__ import annotations

import shutil
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from day6_core.graph.graph import GraphEvent
from day6_core.graph.node import Node
from day6_core.ros.programs import load
from day6_core.ros.programs.day6_inspector.finding import Finding
from day6_core.ros.programs.day6_inspector.model import Inspector
from day6_core.session.streams import InputStream, Pipe
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams
from day6_core.shell.terminal import Terminal
from tests.support.stacks import stacks
from tests.support.waiting import PATIENCE, Deadline, until

SETTLING = 2
"""Looks of the inspector, one every half second of the world, without a change of the graph: then all is there."""

SETTLED = 4
"""Looks at which a healthy scene must stay without findings."""


class Lab:
    """A desk with its own clock and processes; `close` ends everything."""

    def __init__(self, home: Path) -> None:
        self.desk = Desk(home, domain_id=0)
        self.home = self.desk.home
        self.desk.start()
        self.terminals: list[Terminal] = []
        self.inspector = self._open_inspector()
        self._looks = 0
        self._changed_at = 0
        """The look at which the graph changed last."""
        self._said: dict[str, str] = {}
        """Warnings and errors since it was emptied: key -> text."""
        self._follow_looks()

    def _open_inspector(self) -> Inspector:
        self._printed = Pipe()
        streams = Streams(InputStream(), self._printed.writer, self._printed.writer)

        def start() -> None:
            main = load("day6_inspector", "inspector")
            self.desk.start_program(["inspector"], main, streams, env=self.desk.environment(), cwd=self.home)

        self.desk.scheduler.call_soon_threadsafe(start)
        return until(lambda: next((each.model for each in self.windows("inspector")), None), told=lambda: "no window")

    def _follow_looks(self) -> None:
        look = self.inspector.refresh

        def refresh() -> None:
            look()
            self._looks += 1
            found = [(key, each.text) for key, each in self.findings.items() if each.level != "info" and key != "late"]
            self._said.update(found)

        def changed(event: GraphEvent) -> None:
            subject = event.subject
            node = subject if isinstance(subject, Node) else subject.node
            if not node.is_observer:  # the inspector opens and leaves topics all the time
                self._changed_at = self._looks

        self.inspector.refresh = refresh  # type: ignore[method-assign]
        self.desk.graph.add_listener(changed)

    def windows(self, kind: str) -> list[Any]:
        assert self.desk.display is not None
        return [window for window in self.desk.display.windows if window.kind == kind]

    # -- what a student does -------------------------------------------------------------------------------------------

    def file(self, name: str, text: str) -> Path:
        path = self.home / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def terminal(self, number: int = 0) -> Terminal:
        while len(self.terminals) <= number:
            made: list[Terminal] = []
            self.desk.scheduler.call_soon_threadsafe(lambda made=made: made.append(self.desk.open_terminal(100, 30)))
            until(lambda made=made: made)
            self.terminals.append(made[0])
        return self.terminals[number]

    def screen(self, number: int = 0) -> str:
        terminal = self.terminal(number)
        terminal.update()
        return terminal.screen.text

    def run(self, line: str, number: int = 0) -> str:
        """Type a line and wait until its prompt is back; return what it printed."""
        terminal = self.terminal(number)
        before = len(terminal.runs.all)
        terminal.run_line(line)
        until(
            lambda: len(terminal.runs.all) > before and terminal.runs.all[-1].status is not None,
            told=lambda: self.screen(number),
            meanwhile=terminal.update,
        )
        return terminal.runs.all[-1].output

    def start(self, line: str, number: int = 0, shows: str = "") -> None:
        """Type a line that goes on; wait until it runs and its output shows a text."""
        terminal = self.terminal(number)
        before = len(terminal.runs.all)
        terminal.run_line(line)
        until(
            lambda: len(terminal.runs.all) > before and shows in terminal.runs.all[-1].output,
            told=lambda: self.screen(number),
            meanwhile=terminal.update,
        )

    def interrupt(self, number: int = 0) -> None:
        """Press Ctrl-C and wait for the prompt."""
        terminal = self.terminal(number)
        terminal.send("\x03")
        self.wait(lambda: (terminal.update(), terminal.runs.all[-1].status is not None)[1])

    def wait_node(self, name: str) -> None:
        until(lambda: any(node.full_name == name for node in self.desk.graph.nodes), told=lambda: self.screen())

    def wait(self, condition: Callable[[], object], limit: float = PATIENCE) -> None:
        until(condition, limit, told=lambda: "\n".join(self.screen(number) for number in range(len(self.terminals))))

    # -- what the inspector says ---------------------------------------------------------------------------------------

    @property
    def findings(self) -> dict[str, Finding]:
        return {each.id.removeprefix("inspector."): each for each in self.inspector.findings}

    def finds(self, *keys: str) -> tuple[Finding | None, float]:
        """Wait for one of these findings; returns it, None if it does not come, and the seconds that took."""
        began, deadline = time.monotonic(), Deadline()
        while not deadline.is_over():
            self._update()
            for key in keys:
                if (found := self.findings.get(key)) is not None:
                    return found, time.monotonic() - began
            time.sleep(0.02)
        return None, time.monotonic() - began

    def stays_silent(self, looks: int = SETTLED) -> dict[str, str]:
        """Let the inspector look again and again; return the warnings and errors that it said at any of these looks.

        What comes and goes while the scene is still being set does not count. "info" is worth knowing and no alarm: that nobody
        listens to /turtle1/pose, for instance. That this computer is too slow for what runs is true or not, whatever the scene.
        """
        self.settle()
        begin = self._looks
        self._said.clear()
        self._wait_for_looks(lambda: self._looks - begin >= looks)
        return dict(self._said)

    def settle(self) -> None:
        """Wait until the inspector has looked some times without any change of the graph."""
        begin = self._looks
        self._wait_for_looks(lambda: self._looks - max(begin, self._changed_at) > SETTLING)

    def _wait_for_looks(self, condition: Callable[[], bool]) -> None:
        until(condition, told=self._how_it_stands, meanwhile=self._update)

    def _how_it_stands(self) -> str:
        """For a failure: whether the inspector has ended, or what it hangs in."""
        clock = self.desk.clock
        return "\n".join(
            [
                f"{self._looks} looks, a change at {self._changed_at}; world {clock.steady_ns() / 1e9:.1f} s, {clock.paused=}",
                f"programs {[program.session.argv for program in self.desk.programs.values()]}",
                f"the inspector printed {''.join(self._printed._chunks)!r}",
                *stacks(),
            ]
        )

    def _update(self) -> None:
        for terminal in list(self.desk.terminals):
            terminal.update()

    def close(self) -> None:
        self.desk.hurry()
        self.desk.close()
        shutil.rmtree(self.home, ignore_errors=True)
