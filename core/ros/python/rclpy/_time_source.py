"""Where a context's clocks read the time."""

from __future__ import annotations

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
