"""Rate and bandwidth of one topic, measured from received messages."""

from __future__ import annotations

import threading
from collections import deque

SECOND = 1_000_000_000
WINDOW_NS = 5 * SECOND
"""Messages older than this no longer count."""

MOST = 20_000
"""Messages kept for measuring, however fast they come."""

BARS = 30
"""Steps of the sparkline, one for each look at the numbers."""


class Measure:
    """Measures messages and bytes per second; call `add` for every message, on the thread that received it."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._arrivals: deque[tuple[int, int]] = deque()
        self._bytes = 0
        """Of the messages in `_arrivals`."""
        self._bars: deque[float] = deque(maxlen=BARS)
        self._before_bar = 0
        self._bar_ns: int | None = None
        self.count = 0

    def add(self, now_ns: int, size: int) -> None:
        """Count a received message of `size` bytes."""
        with self._lock:
            self._arrivals.append((now_ns, size))
            self._bytes += size
            self.count += 1
            if len(self._arrivals) > MOST:
                self._bytes -= self._arrivals.popleft()[1]

    def rates(self, now_ns: int) -> tuple[float, float] | None:
        """Messages per second and bytes per second; None before there are two messages, or when they have stopped."""
        with self._lock:
            arrivals = self._arrivals
            while arrivals and now_ns - arrivals[0][0] > WINDOW_NS:
                self._bytes -= arrivals.popleft()[1]
            count, size = len(arrivals), self._bytes
            if count < 2:
                return None
            first, last = arrivals[0][0], arrivals[-1][0]
        # A gap longer than any before it belongs to the measure: a topic that falls silent gets slower, not stuck.
        span = max(last - first, now_ns - first - (last - first) // (count - 1))
        if span <= 0:
            return None
        return (count - 1) * SECOND / span, size * SECOND / span

    def tick(self, now_ns: int) -> None:
        """Close a step of the sparkline."""
        if self._bar_ns is not None and now_ns > self._bar_ns:
            self._bars.append((self.count - self._before_bar) * SECOND / (now_ns - self._bar_ns))
        self._bar_ns = now_ns
        self._before_bar = self.count

    @property
    def bars(self) -> tuple[float, ...]:
        """Messages per second in each of the last steps, oldest first."""
        return tuple(self._bars)
