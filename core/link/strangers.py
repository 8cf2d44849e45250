"""Senders of messages that no token announced: theirs is still on the way, or gone already, or they are none of ours."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

from day6_tui.core.graph.endpoints import Publisher
from day6_tui.core.link.limits import MOST_STRANGERS, STRANGER_SECONDS

Key = tuple[bytes, str]
"""GID and topic."""


class Strangers:
    """Keeps a stand-in for each, for `STRANGER_SECONDS` after its last message and for at most `MOST_STRANGERS`. Thread-safe."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._lock = threading.Lock()
        self._known: dict[Key, tuple[Publisher, float]] = {}
        """With the time of its last message, the oldest first."""

    def __len__(self) -> int:
        return len(self._known)

    def get(self, key: Key, make: Callable[[], Publisher]) -> Publisher:
        """Return the stand-in for a sender, which has just sent something."""
        with self._lock:
            known = self._known.pop(key, None)
            stranger = make() if known is None else known[0]
            self._known[key] = stranger, self._now()
            self._forget_old()
        return stranger

    def forget_old(self) -> None:
        """Forget who has been silent. To be called now and then."""
        with self._lock:
            self._forget_old()

    def clear(self) -> None:
        """Forget all."""
        with self._lock:
            self._known.clear()

    def _forget_old(self) -> None:
        before = self._now() - STRANGER_SECONDS
        while self._known:
            oldest = next(iter(self._known))
            if self._known[oldest][1] >= before and len(self._known) <= MOST_STRANGERS:
                return
            del self._known[oldest]
