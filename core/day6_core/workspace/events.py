"""The events of a run, passed to the handlers that print or log them."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Protocol

from day6_core.session.streams import OutputStream
from day6_core.workspace.style import Styler

LOG_LEVELS = {"CRITICAL": 50, "ERROR": 40, "WARNING": 30, "INFO": 20, "DEBUG": 10}
"""The levels of colcon's log."""

INTERRUPTED = "SIGINT"
"""The result of a job ended by Ctrl-C; other results are numbers."""

Result = int | str


@dataclass(frozen=True)
class BuildEvent:
    """One event. `kind` is one of queued, started, command, command_ended, stdout, stderr, test_failure, ended, tick, end."""

    kind: str
    job: str = ""
    """The package's name; '' for events of the whole run."""
    text: str = ""
    """A line of stdout or stderr (with its newline), or the command."""
    result: Result = 0


class Handler(Protocol):
    """Receives every event, in order, one at a time."""

    def handle(self, event: BuildEvent) -> None:
        """Handle one event."""


@dataclass
class Console:
    """The streams a run prints to, and its start, `begun`, in seconds of `time.monotonic`."""

    stdout: OutputStream
    stderr: OutputStream
    begun: float = field(default_factory=time.monotonic)
    status: str = ""
    """The status line on the screen now, to be wiped before anything else is printed."""
    environment: Mapping[str, str] = field(default_factory=dict)
    log_level: int = LOG_LEVELS["WARNING"]
    """What is less important than this is not printed."""
    _lock: threading.RLock = field(default_factory=threading.RLock)

    def __post_init__(self) -> None:
        self.out_style = Styler(self.stdout, self.environment)
        self.err_style = Styler(self.stderr, self.environment)

    def out(self, text: str) -> None:
        """Print to standard output."""
        with self._lock:
            self.wipe()
            self.stdout.write(text)
            self.stdout.flush()

    def err(self, text: str) -> None:
        """Print to standard error."""
        with self._lock:
            self.wipe()
            self.stderr.write(text)
            self.stderr.flush()

    def wipe(self) -> None:
        """Remove the status line from the screen."""
        if self.status:
            self.stdout.write(" " * len(self.status))
            self.stdout.control("\r")
            self.status = ""

    def show_status(self, text: str) -> None:
        """Show a status line, replacing the previous one."""
        with self._lock:
            self.wipe()
            self.stdout.write(text)
            self.stdout.control("\r")
            self.stdout.flush()
            self.status = text

    def warn(self, logger: str, text: str, level: str = "WARNING") -> None:
        """Print a message of colcon's log: `[0.123s] WARNING:colcon.…: text`; a plain line if `logger` is empty."""
        if not logger:
            self.err(f"{text}\n")
        elif LOG_LEVELS[level] >= self.log_level:
            self.err(f"[{time.monotonic() - self.begun:.3f}s] {level}:{logger}:{text}\n")


class Events:
    """Passes events to the handlers. Thread-safe."""

    def __init__(self, handlers: Iterable[Handler]) -> None:
        self._handlers = list(handlers)
        self._lock = threading.RLock()

    def emit(self, event: BuildEvent) -> None:
        """Pass one event to every handler."""
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
