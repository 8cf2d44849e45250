"""Output of a program while one of its windows has the terminal: kept, and printed once the terminal is free again."""

from __future__ import annotations

import re
import threading
from collections import deque
from collections.abc import Callable
from typing import Protocol

MOST_LINES = 1000
"""Lines that are kept; beyond that the oldest are dropped, and their number is printed."""
_LONGEST_LINE = 4096
_COLOURS = re.compile(r"\x1b\[[0-9;]*m")


class Sink(Protocol):
    """Where the lines go in the end."""

    def write(self, text: str) -> int:
        """Take `text`; returns its length, as `io.TextIOBase.write` does."""


class Backlog:
    """Lines for one or more outputs, in the order in which they were written. Any thread may write and read."""

    def __init__(self) -> None:
        self._lines: deque[tuple[Sink | None, str]] = deque(maxlen=MOST_LINES)
        self._open: dict[Sink | None, str] = {}
        """The unfinished line of each output."""
        self._lock = threading.Lock()
        self.on_change: Callable[[], None] = lambda: None
        """Called after every line, on the thread that wrote it."""
        self.dropped = 0
        self.version = 0
        """Grows with every line."""

    def write(self, sink: Sink | None, text: str) -> None:
        """Keep `text` for `sink`; None if it has been written already and is kept only to be shown."""
        with self._lock:
            *lines, rest = (self._open.pop(sink, "") + text).split("\n")
            if len(rest) > _LONGEST_LINE:
                lines.append(rest)
                rest = ""
            if rest:
                self._open[sink] = rest
            for line in lines:
                if len(self._lines) == MOST_LINES and self._lines[0][0] is not None:
                    self.dropped += 1
                self._lines.append((sink, line + "\n"))
            self.version += len(lines)
        if lines:
            self.on_change()

    def lines(self) -> list[str]:
        """The kept lines, oldest first, without newlines and colours."""
        with self._lock:
            return [_COLOURS.sub("", line).rstrip("\n") for _, line in self._lines]

    @property
    def last(self) -> str:
        """The newest line, '' if there is none; as `lines`."""
        with self._lock:
            return _COLOURS.sub("", self._lines[-1][1]).rstrip("\n") if self._lines else ""

    def release(self) -> None:
        """Write every line to its sink and start empty again."""
        with self._lock:
            kept = [*self._lines, *self._open.items()]
            dropped, self.dropped = self.dropped, 0
            self._lines.clear()
            self._open.clear()
        lines = [(sink, line) for sink, line in kept if sink is not None]
        if dropped and lines:
            lines[0][0].write(f"… {dropped} lines dropped\n")
        for sink, line in lines:
            sink.write(line)
