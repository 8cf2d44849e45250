"""What happens while packages are processed, told to whoever prints or logs it."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Protocol

from day6_tui.core.session.streams import OutputStream

INTERRUPTED = "SIGINT"
"""The result of a job that Ctrl-C ended, where others have a number."""

Result = int | str


@dataclass(frozen=True)
class Event:
    """One event. `kind` is one of queued, started, command, command_ended, stdout, stderr, test_failure, ended, tick, end."""

    kind: str
    job: str = ""
    """The package's name; '' for events of the whole run."""
    text: str = ""
    """The line of stdout and stderr (with its newline), the command."""
    result: Result = 0


class Handler(Protocol):
    """Gets every event, in order, one at a time."""

    def handle(self, event: Event) -> None: ...


@dataclass
class Console:
    """Where a run prints, and how it knows the time. `begun` is in seconds of `time.monotonic`."""

    stdout: OutputStream
    stderr: OutputStream
    begun: float = field(default_factory=time.monotonic)
    status: str = ""
    """The status line that is on the screen now, to be wiped before anything else is printed."""
    _lock: threading.RLock = field(default_factory=threading.RLock)

    def out(self, text: str) -> None:
        with self._lock:
            self.wipe()
            self.stdout.write(text)
            self.stdout.flush()

    def err(self, text: str) -> None:
        with self._lock:
            self.wipe()
            self.stderr.write(text)
            self.stderr.flush()

    def wipe(self) -> None:
        if self.status:
            self.stdout.write(" " * len(self.status))
            self.stdout.control("\r")
            self.status = ""

    def show_status(self, text: str) -> None:
        with self._lock:
            self.wipe()
            self.stdout.write(text)
            self.stdout.control("\r")
            self.stdout.flush()
            self.status = text

    def warn(self, logger: str, text: str, level: str = "WARNING") -> None:
        """Print a message of colcon's log: `[0.123s] WARNING:colcon.…: text`; a plain line where no logger is named."""
        if not logger:
            self.err(f"{text}\n")
            return
        self.err(f"[{time.monotonic() - self.begun:.3f}s] {level}:{logger}:{text}\n")


class Events:
    """Passes events on to the handlers. Any thread may tell."""

    def __init__(self, handlers: Iterable[Handler]) -> None:
        self._handlers = list(handlers)
        self._lock = threading.RLock()

    def tell(self, event: Event) -> None:
        with self._lock:
            for handler in self._handlers:
                handler.handle(event)


def duration(seconds: float) -> str:
    """Return '0.52s', '12.3s', '1min 5s', '1h 0min 5s'."""
    minutes, rest = divmod(max(seconds, 0.0), 60)
    hours, minutes = divmod(minutes, 60)
    decimals = 0 if hours or minutes else 2 if round(rest, 2) < 9.995 else 1
    shown = f"{rest:.{decimals}f}s"
    if minutes or hours:
        shown = f"{int(minutes)}min {shown}"
    return f"{int(hours)}h {shown}" if hours else shown
