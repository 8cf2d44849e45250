"""What a program writes while a window of it has the terminal: kept, and printed when the terminal is free again."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from typing import Protocol

MOST_LINES = 1000
"""What is kept; of more the oldest lines go, and their number is said."""
_LONGEST_LINE = 4096


class Sink(Protocol):
    """Where the lines go in the end."""

    def write(self, text: str) -> int: ...


class Backlog:
    """Lines for one or more outputs, in the order in which they were written. Any thread may write and look."""

    def __init__(self, on_change: Callable[[], None] = lambda: None) -> None:
        self._lines: deque[tuple[Sink, str]] = deque(maxlen=MOST_LINES)
        self._open: dict[Sink, str] = {}
        """The unfinished line of each output."""
        self._lock = threading.Lock()
        self._on_change = on_change
        self.dropped = 0
        self.version = 0
        """Grows with every line."""

    def write(self, sink: Sink, text: str) -> None:
        """Keep `text` for `sink`."""
        with self._lock:
            *lines, rest = (self._open.pop(sink, "") + text).split("\n")
            if len(rest) > _LONGEST_LINE:
                lines.append(rest)
                rest = ""
            if rest:
                self._open[sink] = rest
            for line in lines:
                if len(self._lines) == MOST_LINES:
                    self.dropped += 1
                self._lines.append((sink, line + "\n"))
            self.version += len(lines)
        if lines:
            self._on_change()

    def lines(self) -> list[str]:
        """The lines that are kept, oldest first, without their ends."""
        with self._lock:
            return [line.rstrip("\n") for _, line in self._lines]

    @property
    def last(self) -> str:
        """The newest line, '' if there is none."""
        with self._lock:
            return self._lines[-1][1].rstrip("\n") if self._lines else ""

    def release(self) -> None:
        """Write everything to where it was meant for, and begin anew."""
        with self._lock:
            lines = [*self._lines, *self._open.items()]
            dropped, self.dropped = self.dropped, 0
            self._lines.clear()
            self._open.clear()
        if dropped and lines:
            lines[0][0].write(f"… {dropped} lines dropped\n")
        for sink, line in lines:
            sink.write(line)
