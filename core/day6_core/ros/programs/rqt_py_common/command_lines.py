"""Command lines and what they print, as the shell and the Python console of rqt show them."""

from __future__ import annotations

import threading
import time
from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable
from enum import Enum

from day6_core.session.streams import OutputStream
from day6_core.session.task import let_others_run

MOST_LINES = 2_000
MOST_CHARACTERS = 2_000
"""Of one line; the rest is cut off."""

BURST, PAUSE = 64 * 1024, 0.02
"""After so many characters a process that prints without end waits so many seconds: nobody reads faster."""


class Kind(Enum):
    """What a line is."""

    COMMAND = "command"
    OUTPUT = "output"
    ERROR = "error"
    REMARK = "remark"
    """A sentence of ours, which the window has in the user's language; the line is its name."""


class CommandLines(ABC):
    """What models of such windows have in common; any thread may call any method."""

    def __init__(self) -> None:
        self._lines: deque[tuple[Kind, str]] = deque(maxlen=MOST_LINES)
        self._open: Kind | None = None
        """The kind of the last line while it has no end."""
        self._lock = threading.RLock()
        self.history: deque[str] = deque(maxlen=MOST_LINES)
        """What was typed, the oldest first."""
        self.version = 0

    @property
    def lines(self) -> list[tuple[Kind, str]]:
        """What there is to see, the oldest first."""
        with self._lock:
            return list(self._lines)

    @property
    @abstractmethod
    def prompt(self) -> str | None:
        """What stands before the line that is typed; None while nothing waits for one."""

    @property
    @abstractmethod
    def can_interrupt(self) -> bool:
        """Whether `interrupt` would change anything."""

    @abstractmethod
    def run(self, line: str) -> bool:
        """Take a line that was typed; False if it cannot be taken now."""

    @abstractmethod
    def interrupt(self) -> None:
        """End what runs, as Ctrl-C does."""

    def take(self, text: str, kind: Kind) -> None:
        """Add text that was printed."""
        with self._lock:
            pieces = text.split("\n")
            if self._open is kind and self._lines:
                _, before = self._lines.pop()
                pieces[0] = before + pieces[0]
            self._open = kind if pieces[-1] else None
            self._lines.extend((kind, piece[:MOST_CHARACTERS]) for piece in (pieces if pieces[-1] else pieces[:-1]))
            self.version += 1

    def _show_command(self, text: str) -> None:
        """Add a line that was typed, with its prompt."""
        self._lines.append((Kind.COMMAND, text))
        self._open = None
        self.version += 1


class Printed(OutputStream):
    """Output that `take` gets, on the thread that prints it."""

    def __init__(self, take: Callable[[str], object]) -> None:
        self._take = take
        self._since_pause = 0

    def write(self, text: str) -> int:
        self._take(text)
        self._since_pause += len(text)
        return len(text)

    async def drain(self) -> None:
        await let_others_run()  # an endless program must not hold up the others

    def wait_for_room(self) -> None:
        if self._since_pause >= BURST:
            self._since_pause = 0
            time.sleep(PAUSE)
