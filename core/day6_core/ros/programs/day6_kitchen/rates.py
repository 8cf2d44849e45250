"""How often messages pass on a topic, measured from a counter that is looked at now and then."""

from __future__ import annotations

from collections import deque

WINDOW_SECONDS = 5.0
"""What is older no longer counts."""


class Rate:
    """The rate of one counter. Times are seconds of a monotonic clock."""

    def __init__(self) -> None:
        self._changes: deque[tuple[float, int]] = deque()
        self._count = 0

    def see(self, now: float, fresh: int) -> None:
        """`fresh` messages have passed since the last look."""
        if fresh > 0:
            self._count += fresh
            self._changes.append((now, self._count))
        while self._changes and now - self._changes[0][0] > WINDOW_SECONDS:
            self._changes.popleft()

    def hertz(self, now: float) -> float:
        """Messages a second; 0 when there were too few lately to tell.

        A pause that is longer than any before it counts: a topic that falls silent gets slower, and is not stuck.
        """
        changes = self._changes
        if len(changes) < 2:
            return 0.0
        (first, before), (last, count) = changes[0], changes[-1]
        span = max(last - first, now - first - (last - first) / (len(changes) - 1))
        return (count - before) / span if span > 0 else 0.0
