"""Where a context's clocks read the time."""

from __future__ import annotations

import os
import threading
import time
from typing import Protocol

from day6_core.virtual.surroundings import is_virtual


class TimeBase(Protocol):
    """What a context needs to tell the time; in day6-tui day6_core/session/clock.py, which says who reads which."""

    def now_ns(self) -> int:
        """Nanoseconds since 1970 (ROS and system time): what is stamped and measured."""

    def steady_ns(self) -> int:
        """Nanoseconds since some fixed moment, never going back: what timers and waits run by."""


class MachineTime:
    """The machine's own clocks."""

    now_ns = staticmethod(time.time_ns)
    steady_ns = staticmethod(time.monotonic_ns)


MACHINE_TIME: TimeBase = MachineTime()

# Long waits are done in pieces. On Windows a lock that is waited for cannot be interrupted by Ctrl-C; elsewhere a signal that
# comes between Python's last look for one and the wait itself would be noticed only at the wait's end. In virtual time none is
# missed, and time would go on for nothing else than these pieces.
LONGEST_WAIT_S = threading.TIMEOUT_MAX if is_virtual() else 0.1 if os.name == "nt" else 0.25


def wait_interruptibly(event: threading.Event, seconds: float | None) -> bool:
    """Wait for an event like `Event.wait`, but so that Ctrl-C ends it on every system."""
    left = float("inf") if seconds is None else seconds
    while left > 0:
        if event.wait(min(left, LONGEST_WAIT_S)):
            return True
        left -= LONGEST_WAIT_S
    return event.is_set()


class AutoResetEvent:
    """What one thread waits for and others set, for waits that rcl does inside: Ctrl-C shows no line of `threading`.

    Setting it lets one `wait` through, however often it was set before, and that resets it.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._lock.acquire()

    def set(self) -> None:
        """Let the waiting thread go on, or the next that comes; from any thread."""
        try:
            self._lock.release()
        except RuntimeError:
            # It is set.
            return

    def wait(self, seconds: float | None) -> bool:
        """Wait until it is set, at most for that long (None: for ever); says whether it was."""
        left = threading.TIMEOUT_MAX if seconds is None else min(seconds, threading.TIMEOUT_MAX)
        while left > 0:
            if self._lock.acquire(timeout=min(left, LONGEST_WAIT_S)):
                return True
            left -= LONGEST_WAIT_S
        return self._lock.acquire(blocking=False)
