"""Where a context's clocks read the time."""

from __future__ import annotations

import os
import threading
import time
from typing import Protocol


class TimeSource(Protocol):
    """What a context needs to tell the time; core/session passes the world clock."""

    def now_ns(self) -> int:
        """Nanoseconds since 1970 (ROS and system time)."""

    def steady_ns(self) -> int:
        """Nanoseconds since some fixed moment, never going back."""


class MachineTime:
    """The machine's own clocks."""

    now_ns = staticmethod(time.time_ns)
    steady_ns = staticmethod(time.monotonic_ns)


MACHINE_TIME: TimeSource = MachineTime()

# A lock that is waited for cannot be interrupted by Ctrl-C on Windows, so there long waits are done in pieces.
LONGEST_WAIT_S: float | None = 0.1 if os.name == "nt" else None


def wait_interruptibly(event: threading.Event, seconds: float | None) -> bool:
    """Wait for an event like `Event.wait`, but so that Ctrl-C ends it on every system."""
    if LONGEST_WAIT_S is None:
        return event.wait(seconds)
    left = float("inf") if seconds is None else seconds
    while left > 0:
        if event.wait(min(left, LONGEST_WAIT_S)):
            return True
        left -= LONGEST_WAIT_S
    return event.is_set()
