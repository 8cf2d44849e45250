"""Senders of messages without a token: it is still on the way or already gone, or the sender is not an rmw_zenoh node."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

from day6_core.graph.endpoints import Publisher
from day6_core.link.limits import MOST_UNANNOUNCED, UNANNOUNCED_SECONDS

Key = tuple[bytes, str]
"""GID and topic."""


class UnannouncedSenders:
    """Keeps a placeholder publisher for each sender, for `UNANNOUNCED_SECONDS` after its last message. Thread-safe.

    At most `MOST_UNANNOUNCED` are kept; the one that was silent longest goes first.
    """

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._lock = threading.Lock()
        self._known: dict[Key, tuple[Publisher, float]] = {}
        """With the time of the last message (seconds), oldest first."""

    def __len__(self) -> int:
        return len(self._known)

    def get(self, key: Key, make: Callable[[], Publisher]) -> Publisher:
        """Return the placeholder for a sender that has just sent something."""
        with self._lock:
            known = self._known.pop(key, None)
            publisher = make() if known is None else known[0]
            self._known[key] = publisher, self._now()
            self._forget_old()
        return publisher

    def forget_old(self) -> None:
        """Forget silent senders. To be called periodically."""
        with self._lock:
            self._forget_old()

    def clear(self) -> None:
        """Forget all."""
        with self._lock:
            self._known.clear()

    def _forget_old(self) -> None:
        before = self._now() - UNANNOUNCED_SECONDS
        while self._known:
            oldest = next(iter(self._known))
            if self._known[oldest][1] >= before and len(self._known) <= MOST_UNANNOUNCED:
                return
            del self._known[oldest]
