"""Rate and bandwidth of one topic, measured from received messages."""

from __future__ import annotations

from collections import deque

SECOND = 1_000_000_000
WINDOW_NS = 5 * SECOND
"""Messages older than this no longer count."""

MOST = 20_000
"""Messages kept for measuring, however fast they come."""

BARS = 30
"""Steps of the sparkline, one for each look at the numbers."""


class Measure:
    """Measures messages and bytes per second; call `add` for every message."""

    def __init__(self) -> None:
        self._arrivals: deque[tuple[int, int]] = deque(maxlen=MOST)
        self._bars: deque[float] = deque(maxlen=BARS)
        self._since_bar = 0
        self._bar_ns: int | None = None
        self.count = 0

    def add(self, now_ns: int, size: int) -> None:
        """Count a received message of `size` bytes."""
        self._arrivals.append((now_ns, size))
        self.count += 1
        self._since_bar += 1

    def rates(self, now_ns: int) -> tuple[float, float] | None:
        """Messages per second and bytes per second; None before there are two messages, or when they have stopped."""
        arrivals = self._arrivals
        while arrivals and now_ns - arrivals[0][0] > WINDOW_NS:
            arrivals.popleft()
        if len(arrivals) < 2:
            return None
        first, last = arrivals[0][0], arrivals[-1][0]
        # A gap longer than any before it belongs to the measure: a topic that falls silent gets slower, not stuck.
        span = max(last - first, now_ns - first - (last - first) // (len(arrivals) - 1))
        if span <= 0:
            return None
        return (len(arrivals) - 1) * SECOND / span, sum(size for _, size in arrivals) * SECOND / span

    def tick(self, now_ns: int) -> None:
        """Close a step of the sparkline."""
        if self._bar_ns is not None and now_ns > self._bar_ns:
            self._bars.append(self._since_bar * SECOND / (now_ns - self._bar_ns))
        self._bar_ns = now_ns
        self._since_bar = 0

    @property
    def bars(self) -> tuple[float, ...]:
        """Messages per second in each of the last steps, oldest first."""
        return tuple(self._bars)
