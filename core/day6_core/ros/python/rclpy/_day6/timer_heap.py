"""The timers of an executor, by deadline."""

from __future__ import annotations

import heapq
from collections import deque
from collections.abc import Callable
from itertools import count
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy._day6.rounds import ExecutorRounds
    from rclpy.event_handler import EventHandler
    from rclpy.timer import Timer


class TimerHeap:
    """A heap of deadlines (ns of the steady clock). Outdated entries are skipped, not removed."""

    __slots__ = ("_executor", "_numbers", "entries")

    def __init__(self, executor: ExecutorRounds) -> None:
        self._executor = executor
        self._numbers = count()
        self.entries: list[tuple[int, int, Timer | EventHandler]] = []

    def add(self, timer: Timer | EventHandler) -> bool:
        """Add the timer's next call; returns whether it is the earliest of all."""
        deadline = timer._next
        if timer._heap is self and timer._heap_deadline == deadline:
            return False
        timer._heap = self
        timer._heap_deadline = deadline
        heapq.heappush(self.entries, (deadline, next(self._numbers), timer))
        return self.entries[0][2] is timer

    def first_deadline(self) -> int | None:
        """Return the earliest deadline, None if there is none."""
        entries = self.entries
        while entries:
            deadline, _, timer = entries[0]
            if timer._heap is self and timer._heap_deadline == deadline:
                scope = timer._scope
                if scope is not None and scope.executor is self._executor and not timer._canceled:
                    return deadline
                timer._heap = None
            heapq.heappop(entries)
        return None

    def move_due(self, now: Callable[[], int], ready: deque[Any]) -> None:
        """Append to `ready` the timers that are due and not queued yet."""
        read: int | None = None
        while True:
            deadline = self.first_deadline()
            if deadline is None:
                return
            if read is None:
                read = now()
            if deadline > read:
                return
            timer = heapq.heappop(self.entries)[2]
            timer._heap = None
            if not timer._queued:
                timer._queued = True
                ready.append(timer)
