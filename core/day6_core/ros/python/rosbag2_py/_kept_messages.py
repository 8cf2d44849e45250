"""Messages that a writer keeps in memory: the last moments for a snapshot, and the last ones of topics that are repeated."""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

SECOND = 1_000_000_000


class Kept(NamedTuple):
    """A message; times are nanoseconds since 1970."""

    topic: str
    data: bytes
    received_ns: int
    sent_ns: int


class LastMoments:
    """The last messages of all topics, up to so many bytes and seconds; 0 seconds mean no limit, 0 bytes only beside seconds."""

    def __init__(self, size: int, seconds: int) -> None:
        self._most_bytes = size
        self._longest_ns = seconds * SECOND
        self._kept: deque[Kept] = deque()
        self._bytes = 0

    def add(self, message: Kept) -> None:
        """Keep a message, and drop the oldest ones."""
        self._kept.append(message)
        self._bytes += len(message.data)
        while len(self._kept) > 1 and self._is_over(message.received_ns):
            self._bytes -= len(self._kept.popleft().data)

    def _is_over(self, now_ns: int) -> bool:
        limited = self._most_bytes or not self._longest_ns
        return bool(limited and self._bytes > self._most_bytes) or bool(
            self._longest_ns and now_ns - self._kept[0].received_ns > self._longest_ns
        )

    def take(self) -> list[Kept]:
        """Return what is kept, and keep nothing."""
        kept, self._kept, self._bytes = list(self._kept), deque(), 0
        return kept


class LastMessages:
    """The last messages of chosen topics, which each new file begins with (rosbag2_cpp, TransientLocalMessagesCache)."""

    def __init__(self) -> None:
        self._queues: dict[str, deque[Kept]] = {}

    def add_topic(self, name: str, depth: int) -> None:
        """Keep so many messages of a topic."""
        self._queues.setdefault(name, deque(maxlen=depth))

    def add(self, message: Kept) -> None:
        """Keep a message if its topic is one of those."""
        queue = self._queues.get(message.topic)
        if queue is not None:
            queue.append(message)

    def as_of(self, received_ns: int, sent_ns: int, *, before: bool = False) -> list[Kept]:
        """Return them in their order, as if they came at this time; with `before` only those that did come before it."""
        kept = (each for queue in self._queues.values() for each in queue)
        order = sorted(kept, key=lambda each: (each.received_ns, each.sent_ns, each.topic))
        return [
            each._replace(received_ns=received_ns, sent_ns=sent_ns)
            for each in order
            if not before or each.received_ns < received_ns
        ]
