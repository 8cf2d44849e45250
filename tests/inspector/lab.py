"""A whole machine in which things go wrong for real, and the inspector looking on as after F6."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from waiting import PATIENCE, until

from day6_tui.core.ros.programs import load
from day6_tui.core.ros.programs.day6_inspector.finding import Finding
from day6_tui.core.ros.programs.day6_inspector.model import Inspector
from day6_tui.core.session.streams import InputStream, OutputStream
from day6_tui.core.shell.desk import Desk
from day6_tui.core.shell.language.redirection import Streams
from day6_tui.core.shell.terminal import Terminal

WITHIN = 2.0
"""Seconds after a symptom in which it has to be named."""

SETTLING = 0.8
"""Seconds that a scene has after its last step: a publisher may come a moment after its listener."""

SETTLED = 1.6
"""Seconds in which a healthy scene must stay without findings."""


def patience() -> float:
    """`WITHIN`, and as much longer as more programs want to run than this computer has processors."""
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else 1.0
    return WITHIN * min(10.0, max(1.0, load / (os.cpu_count() or 1)))


class Lab:
    """A desk with its own clock and processes; `close` ends everything."""

    def __init__(self, home: Path) -> None:
        self.desk = Desk(home, domain_id=0)
        self.home = self.desk.home
        self.desk.start()
        self.terminals: list[Terminal] = []
        self.inspector = self._open_inspector()

    def _open_inspector(self) -> Inspector:
        streams = Streams(InputStream(), OutputStream(), OutputStream())

        def start() -> None:
            main = load("day6_inspector", "inspector")
            self.desk.start_program(["inspector"], main, streams, env=self.desk.environment(), cwd=self.home)

        self.desk.scheduler.call_soon_threadsafe(start)
        return until(lambda: next((each.model for each in self.windows("inspector")), None), told=lambda: "no window")

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

    def finds(self, *keys: str, within: float | None = None) -> tuple[Finding | None, float]:
        """Wait for one of these findings; returns it, None if it does not come, and the seconds that took."""
        began = time.monotonic()
        within = patience() if within is None else within
        while (taken := time.monotonic() - began) < within:
            for terminal in self.terminals:
                terminal.update()
            for key in keys:
                if (found := self.findings.get(key)) is not None:
                    return found, taken
            time.sleep(0.02)
        return None, taken

    def stays_silent(self, seconds: float = SETTLED) -> dict[str, str]:
        """Watch for a while; return the warnings and errors that were said. What comes and goes at the start does not count.

        "info" is worth knowing and no alarm: that nobody listens to /turtle1/pose, for instance. That this computer is too slow
        for what runs is true or not, whatever the scene.
        """
        time.sleep(SETTLING)
        said: dict[str, str] = {}
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for terminal in list(self.desk.terminals):
                terminal.update()
            said.update(
                {key: each.text for key, each in self.findings.items() if each.level != "info" and key != "late"}
            )
            time.sleep(0.05)
        return said

    def close(self) -> None:
        self.desk.hurry()
        self.desk.close()
        shutil.rmtree(self.home, ignore_errors=True)
