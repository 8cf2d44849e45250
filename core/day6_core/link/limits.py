"""How much other processes and machines may demand of this one. Anything over a limit is refused, counted and reported.

A class of forty desktops with twenty nodes each stays well within them.
"""

from __future__ import annotations

from collections import Counter
from threading import Lock

MOST_NODES = 2000
"""Remote nodes in total; those of this machine's own processes are admitted beyond it."""
MOST_NODES_OF_ONE = 500
"""Nodes of one Zenoh session, which is one process."""
MOST_ENDPOINTS = 20_000
MOST_ENDPOINTS_OF_ONE = 5000
MOST_WAITING_FOR_ROOM = 20_000
"""Refused announcements that are kept and taken when there is room again; any more are only counted."""
MOST_UNANNOUNCED = 1000
"""Senders of messages without a token."""
UNANNOUNCED_SECONDS = 10.0
"""Silence after which such a sender is forgotten."""
MOST_PRESENCE_TOKENS = 5000
"""Processes and meeting points that announce themselves."""
MOST_WAITING = 50_000
"""Announcements in the queue; with more, all are dropped and requested again."""
MOST_BYTES = 64 * 1024 * 1024
"""Of one message from another machine."""
MOST_MACHINES = 200
"""Machines connected at once."""


class Refusals:
    """Counts what was refused, by reason. Thread-safe."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._counts: Counter[str] = Counter()

    def add(self, reason: str) -> None:
        """Count one refusal."""
        with self._lock:
            self._counts[reason] += 1

    def forget(self, *reasons: str) -> None:
        """Reset some counts to 0."""
        with self._lock:
            for reason in reasons:
                self._counts.pop(reason, None)

    @property
    def counts(self) -> dict[str, int]:
        """Number of refusals by reason."""
        with self._lock:
            return dict(self._counts)
