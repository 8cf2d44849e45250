"""How much other processes and machines may ask of this one. What is over a limit is refused, counted and told.

A lesson of forty desktops, each with twenty nodes, is well inside.
"""

from __future__ import annotations

from collections import Counter
from threading import Lock

MOST_NODES = 2000
"""Remote nodes in all; those of this machine's own processes have their place beside them."""
MOST_NODES_OF_ONE = 500
"""Nodes of one Zenoh session, which is one process."""
MOST_ENDPOINTS = 20_000
MOST_ENDPOINTS_OF_ONE = 5000
MOST_WAITING_FOR_ROOM = 20_000
"""Announcements that were refused and are taken when there is room again; beyond, they are only counted."""
MOST_STRANGERS = 1000
"""Senders of messages that no token announced."""
STRANGER_SECONDS = 10.0
"""After which such a sender, if silent, is forgotten."""
MOST_SIGNS = 5000
"""Processes that say where they are."""
MOST_WAITING = 50_000
"""Announcements that wait to be taken; beyond, all are dropped and asked for anew."""
MOST_BYTES = 64 * 1024 * 1024
"""Of one message from another machine."""
MOST_MACHINES = 200
"""Machines that may be joined at once."""


class Refusals:
    """Counts what was refused, by reason. Thread-safe."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._counts: Counter[str] = Counter()

    def add(self, reason: str) -> None:
        """Count one."""
        with self._lock:
            self._counts[reason] += 1

    def forget(self, *reasons: str) -> None:
        """Begin again at 0."""
        with self._lock:
            for reason in reasons:
                self._counts.pop(reason, None)

    @property
    def counts(self) -> dict[str, int]:
        """How many there were, by reason."""
        with self._lock:
            return dict(self._counts)
