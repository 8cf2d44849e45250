"""What was run in a terminal: the lines, how each ended, and the end of what each printed."""

from __future__ import annotations

from collections import deque
from pathlib import Path

MOST_RUNS = 200
LONGEST_OUTPUT = 32 * 1024
"""Characters that are kept of what one line printed: its end."""

LONGEST_OLD_OUTPUT = 4 * 1024
"""Characters that are kept of it once the next line was run."""


class Run:
    """One line that was run, or still runs: then `status` and `ended_ns` are None. Times are epoch nanoseconds."""

    def __init__(self, number: int, source: str, cwd: Path, began_ns: int) -> None:
        self.number = number
        self.source = source
        self.cwd = cwd
        self.began_ns = began_ns
        self.ended_ns: int | None = None
        self.status: int | None = None
        self.written = 0
        """Characters it printed, with those that are not kept any more."""
        self._explained = 0
        """How many of them there were when it last explained some itself (`ls x; why`)."""
        self._parts: deque[str] = deque()
        self._size = 0

    @property
    def output(self) -> str:
        """The end of what the terminal was given while this ran, with its control sequences."""
        return "".join(list(self._parts))

    @property
    def unexplained(self) -> str:
        """What of the output came after its last explanation."""
        count = self.written - self._explained
        return self.output[-count:] if count else ""

    def explained(self) -> None:
        """Note that what it printed so far was explained, and that the explanation is among it."""
        self._explained = self.written

    def keep(self, text: str, longest: int = LONGEST_OUTPUT) -> None:
        """Add to the output. Any thread."""
        self.written += len(text)
        self._parts.append(text[-longest:])
        self._size += min(len(text), longest)
        while self._size > longest and len(self._parts) > 1:
            self._size -= len(self._parts.popleft())

    def forget_most(self) -> None:
        """Keep the very end of the output only."""
        text = self.output[-LONGEST_OLD_OUTPUT:]
        self._parts, self._size = deque([text]), len(text)


class Runs:
    """The last lines that were run in one terminal, oldest first. Written on the scheduler's thread, read by any."""

    def __init__(self) -> None:
        self._runs: deque[Run] = deque(maxlen=MOST_RUNS)
        self.count = 0
        """How many there were in all."""
        self.running: Run | None = None

    @property
    def all(self) -> list[Run]:
        return list(self._runs)

    def begin(self, source: str, cwd: Path, now_ns: int) -> Run:
        """Note that a line is run now."""
        if self._runs:
            self._runs[-1].forget_most()
        self.count += 1
        run = self.running = Run(self.count, source, cwd, now_ns)
        self._runs.append(run)
        return run

    def end(self, status: int, now_ns: int) -> None:
        """Note how it ended."""
        run, self.running = self.running, None
        if run is not None:
            run.status, run.ended_ns = status, now_ns
