"""A terminal at the end of a slow line: what the program writes waits in a queue, and comes so many bytes a second.

The queue stands for what lies between a program and a terminal over ssh: the buffers of two ptys, two programs and TCP. It takes
what it is given at once, until it is full; so the program's own terminal never says that anything waits. Questions are answered
where a terminal answers them, once everything before them has been read. Linux and macOS.
"""

from __future__ import annotations

import os
import re
import time
from collections.abc import Callable
from pathlib import Path

from tests.e2e.terminal import Terminal, _without_foreign

QUEUE = 16_384
"""Bytes between the program and the terminal."""

TURN = 0.005
"""Seconds between two looks at what has come."""

ANSWERS = {
    b"\x1b[5n": b"\x1b[0n",
    b"\x1b[c": b"\x1b[?62;22c",
    b"\x1b[?2026$p": b"\x1b[?2026;2$y",
}
"""What a terminal without pictures says."""

_QUESTION = re.compile(b"|".join(map(re.escape, ANSWERS)))
_BEGUN = re.compile(rb"\x1b(?:\[(?:\?[0-9]*\$?|[0-9]*)?)?\Z")


class SlowLine(Terminal):
    """A program in a terminal that gets `rate` bytes a second."""

    def __init__(
        self,
        command: list[str],
        columns: int,
        rows: int,
        *,
        cwd: Path,
        env: dict[str, str | None],
        rate: float,
        answers: bool = True,
    ) -> None:
        super().__init__(command, columns, rows, cwd=cwd, env=env)
        self.rate = rate
        self._answers = answers
        self._queue = bytearray()
        self._credit = 0.0
        self._turned = time.monotonic()
        self._was_empty = True
        """Whether nothing waited at the last look."""
        self._rest = b""
        self.read_bytes = 0
        """Bytes that the terminal has read."""
        self.most_waiting = 0
        """The most bytes that ever stood in the queue since this was set to 0."""

    @property
    def written(self) -> int:
        """Bytes that the program has written, as far as the queue took them."""
        return self.read_bytes + len(self._queue)

    @property
    def waiting(self) -> int:
        """Bytes in the queue."""
        return len(self._queue)

    def seconds_until(self, seen: Callable[[], object], limit: float = 60.0) -> float:
        """How long it takes until something is to be seen."""
        began = time.monotonic()
        while not seen():
            if time.monotonic() - began > limit:
                raise AssertionError(f"did not come within {limit} s; the screen shows\n{self.look()}")
            self._take(TURN)
        return time.monotonic() - began

    def settle(self, seconds: float = 1.0) -> None:
        """Look on until nothing has come for so long."""
        quiet, seen = time.monotonic(), self.written
        while time.monotonic() - quiet < seconds:
            self._take(TURN)
            if seen != self.written or self._queue:
                quiet, seen = time.monotonic(), self.written

    def _take(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while True:
            while len(self._queue) < QUEUE and self._more(0.0):
                try:
                    data = os.read(self._fd, QUEUE - len(self._queue))
                except OSError:
                    data = b""
                if not data:
                    break
                self.output += data
                self._queue += data
                self.most_waiting = max(self.most_waiting, len(self._queue))
            self._deliver()
            left = end - time.monotonic()
            if left <= 0:
                return
            if len(self._queue) < QUEUE:
                self._more(min(left, TURN))
                if self._queue:
                    time.sleep(min(max(0.0, end - time.monotonic()), TURN / 5))
            else:
                time.sleep(min(left, TURN))

    def _deliver(self) -> None:
        """Let the terminal read what has come over the line by now."""
        now = time.monotonic()
        seconds = now - self._turned
        if self._was_empty:  # what waits now may have come a moment ago, however late this look is
            seconds = min(seconds, TURN)
        self._credit += seconds * self.rate
        self._turned = now
        count = min(int(self._credit), len(self._queue))
        self._credit = self._credit - count if self._queue else 0.0
        data = bytes(self._queue[:count])
        del self._queue[:count]
        self._was_empty = not self._queue
        self.read_bytes += count
        if not data:
            return
        text = self._rest + data
        begun = _BEGUN.search(text)
        text, self._rest = (text[: begun.start()], text[begun.start() :]) if begun else (text, b"")
        self._stream.feed(_without_foreign(text))
        if self._answers:
            for question in _QUESTION.findall(text):
                os.write(self._fd, ANSWERS[question])
