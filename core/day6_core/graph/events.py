"""Events of endpoints: their counters, and the watches over deadlines and liveliness leases.

Nothing ticks. A watch remembers when something last happened and computes, whenever it is read (`settle`), what has been
missed since; `due` is when the next event would be raised, for callers who want to wake up in time. Times are nanoseconds of
the graph's `now_ns`. Which events are raised was measured on Fast DDS.
"""

from __future__ import annotations

import threading
from enum import Enum
from typing import Protocol

from day6_core.graph.qos import INFINITE_NS, PolicyKind


class EventKind(Enum):
    """The kinds of event (rmw_event_type_t)."""

    INCOMPATIBLE_QOS = "incompatible_qos"
    INCOMPATIBLE_TYPE = "incompatible_type"
    MATCHED = "matched"
    MESSAGE_LOST = "message_lost"
    """Never raised: Fast DDS raises it for gaps in messages from the network, not for a queue that overflows."""
    DEADLINE_MISSED = "deadline_missed"
    LIVELINESS_LOST = "liveliness_lost"
    LIVELINESS_CHANGED = "liveliness_changed"


COUNTERS = (
    "current_count",
    "current_count_change",
    "last_policy_kind",
    "not_alive_count",
    "not_alive_count_change",
    "total_count",
    "total_count_change",
)


class EventStatus:
    """Counters of one kind of event, as in rmw's status structures; `take` resets the changes.

    For LIVELINESS_CHANGED `current_count` is the number of publishers alive. Any thread may count and take.
    """

    __slots__ = ("_lock", *COUNTERS)

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self.total_count = 0
        self.total_count_change = 0
        self.current_count = 0
        self.current_count_change = 0
        self.not_alive_count = 0
        self.not_alive_count_change = 0
        self.last_policy_kind = PolicyKind.INVALID

    def add(self, times: int = 1) -> None:
        """Count occurrences."""
        with self._lock:
            self.total_count += times
            self.total_count_change += times

    def add_current(self, change: int) -> None:
        """Add to the number of those that are matched or alive; may be negative."""
        with self._lock:
            self.current_count += change
            self.current_count_change += change

    def add_alive(self, alive: int, not_alive: int) -> None:
        """Add to the numbers of publishers that are alive and not alive; either may be negative."""
        with self._lock:
            self.current_count += alive
            self.current_count_change += alive
            self.not_alive_count += not_alive
            self.not_alive_count_change += not_alive

    def take(self) -> EventStatus:
        """Return a copy and reset the changes."""
        taken = EventStatus()
        with self._lock:
            for name in COUNTERS:
                setattr(taken, name, getattr(self, name))
            self.total_count_change = self.current_count_change = self.not_alive_count_change = 0
        return taken


class Watch(Protocol):
    """A source of events that time alone can raise. Any thread may call it."""

    def settle(self, now: int) -> None:
        """Count everything missed until `now` (ns)."""

    @property
    def due(self) -> int | None:
        """When the next event will be raised (ns) if nothing happens before; None if nothing is expected."""


class DeadlineWatch:
    """Counts the periods (ns) without a message; the first message starts it."""

    def __init__(self, period: int, status: EventStatus) -> None:
        self._lock = threading.RLock()
        self._period = period
        self._status = status
        self._last: int | None = None

    def message(self, now: int) -> bool:
        """Note a message; return whether it is the first."""
        with self._lock:
            self.settle(now)
            first = self._last is None
            self._last = now
            return first

    def settle(self, now: int) -> None:
        """Count the periods that have ended."""
        with self._lock:
            if self._last is None:
                return
            missed = (now - self._last) // self._period
            if missed > 0:
                self._status.add(missed)
                self._last += missed * self._period

    @property
    def due(self) -> int | None:
        """The end of the present period (ns)."""
        last = self._last
        return None if last is None else last + self._period


class LeaseWatch:
    """The liveliness lease (ns) a publisher offers; the first assertion starts it."""

    def __init__(self, lease: int, status: EventStatus) -> None:
        self._lock = threading.RLock()
        self._lease = lease
        self._status = status
        self._end: int | None = None

    def asserted(self, now: int) -> bool:
        """Note an assertion of liveliness; return whether no lease was running."""
        with self._lock:
            self.settle(now)
            started = self._end is None
            self._end = now + self._lease
            return started

    def settle(self, now: int) -> None:
        """Count a lease that has expired."""
        with self._lock:
            if self._end is not None and now >= self._end:
                self._status.add()
                self._end = None

    @property
    def due(self) -> int | None:
        """The end of the running lease (ns)."""
        return self._end


class AliveWatch:
    """The publishers a subscription considers alive, by the lease (ns) it requests."""

    def __init__(self, lease: int, status: EventStatus) -> None:
        self._lock = threading.RLock()
        self._lease = lease
        self._status = status
        self._ends: dict[object, int | None] = {}
        """publisher -> end of its lease (ns), None after it has expired; absent before its first assertion"""

    def asserted(self, publisher: object, now: int, *, for_ever: bool = False) -> bool:
        """Note an assertion of liveliness; return whether the publisher was not alive before."""
        with self._lock:
            self.settle(now)
            before = self._ends.get(publisher, 0)
            self._ends[publisher] = INFINITE_NS if for_ever else now + self._lease
            if before == 0:
                self._status.add_alive(1, 0)
            elif before is None:
                self._status.add_alive(1, -1)
            return not before

    def gone(self, publisher: object, now: int) -> bool:
        """Forget a publisher; return whether it had ever asserted its liveliness."""
        with self._lock:
            self.settle(now)
            end = self._ends.pop(publisher, 0)
            if end == 0:
                return False
            self._status.add_alive(0, -1) if end is None else self._status.add_alive(-1, 0)
            return True

    def settle(self, now: int) -> None:
        """Count the leases that have expired."""
        with self._lock:
            for publisher, end in self._ends.items():
                if end is not None and now >= end:
                    self._ends[publisher] = None
                    self._status.add_alive(-1, 1)

    @property
    def due(self) -> int | None:
        """The earliest end of a lease (ns)."""
        with self._lock:
            ends = [end for end in self._ends.values() if end is not None and end != INFINITE_NS]
        return min(ends) if ends else None
