"""A whole machine of ours at which a page is played: a desk with its processes, and terminals as a reader opens them."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from day6_core.shell.desk import Desk
from day6_core.shell.runs import Run
from day6_core.shell.terminal import Terminal
from tests.support.waiting import until

COLUMNS, ROWS = 160, 50
UP = "\x1b[A"
LEFT = "\x1b[D"


class Machine:
    """A desk with a home folder; `close` ends everything that runs."""

    def __init__(self, home: Path) -> None:
        self.desk = Desk(home, domain_id=0)
        self.home = self.desk.home
        self.desk.start()
        self.terminals: list[Terminal] = []
        self.by_run: dict[int, Terminal] = {}

    def open(self) -> Terminal:
        """Open one more terminal and wait for its prompt."""
        made: list[Terminal] = []
        self.desk.scheduler.call_soon_threadsafe(lambda: made.append(self.desk.open_terminal(COLUMNS, ROWS)))
        until(lambda: made)
        self.terminals.append(made[0])
        self.wait(lambda: made[0].idle, 30)
        return made[0]

    def type(self, terminal: Terminal, line: str) -> Run:
        """Type a line and Enter; return the run once it has begun."""
        before = terminal.runs.count
        for part in line.split("\n"):
            terminal.send(part + "\r")
        until(lambda: terminal.runs.count > before, told=lambda: terminal.screen.text, meanwhile=self.update)
        run = terminal.runs.all[-1]
        self.by_run[id(run)] = terminal
        return run

    def settle(self, terminal: Terminal, line: str, limit: float = 120.0) -> Run:
        """Type a line that ends by itself and wait for that."""
        run = self.type(terminal, line)
        self.wait(lambda: run.status is not None and terminal.idle, limit)
        return run

    def interrupt(self, terminal: Terminal) -> None:
        """Press Ctrl-C until the prompt is back."""
        for _ in range(3):
            terminal.send("\x03")
            if self.wait(lambda: terminal.idle, 10):
                return

    def update(self) -> None:
        """Let the screens follow, as a view does."""
        for terminal in list(self.desk.terminals):
            terminal.update()

    def wait(self, condition: Callable[[], object], limit: float) -> bool:
        """Wait so many seconds for something; say whether it came."""
        end = time.monotonic() + limit
        while not condition():
            if time.monotonic() > end:
                return False
            self.update()
            time.sleep(0.01)
        return True

    def windows(self) -> list[Any]:
        """Return the windows that programs have opened."""
        return list(self.desk.display.windows) if self.desk.display is not None else []

    def close(self) -> None:
        """End every program."""
        self.desk.hurry()
        self.desk.close()
