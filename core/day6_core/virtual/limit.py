"""A limit to how far the time of a world may be behind what its processes have really taken: then it goes on as real time does.

Otherwise a program that computes and never waits, or one that sleeps for real, would hold all others for as long as it likes.
"""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

from collections.abc import Iterable
from time import monotonic as real_time

from day6_core.virtual import processes

_EVERY = 0.05
"""Real seconds between two looks."""


class Limit:
    """Counts seconds that are the world's own: not those in which its processes wait for a core that others have."""

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds
        self._behind = 0.0
        """Seconds by which time is behind."""
        self._looked = real_time()
        self._now = 0
        self._goes_to = 0
        self._before: dict[int, tuple[float, float]] = {}
        """What each process had used of the cores."""

    def time_at(self, now: int, members: Iterable[int]) -> int:
        """Return the time, ns, to which it goes on whoever holds it; `now` or less if nobody has held it for too long."""
        real = real_time()
        took = real - self._looked
        if took < _EVERY:
            return self._goes_to
        self._behind = max(0.0, self._behind - (now - self._now) / 1e9)
        self._looked, self._now = real, now
        if self._behind + took < self._seconds / 2:
            self._before.clear()  # a busy machine does no harm so far: it needn't be asked for its part
        else:
            took = self._own_part_of(took, members)
        self._behind += took
        self._goes_to = now + int((self._behind - self._seconds) * 1e9)
        return self._goes_to

    def _own_part_of(self, took: float, members: Iterable[int]) -> float:
        after = {pid: processes.used(pid) for pid in {pid for each in members for pid in processes.tree(each)}}
        before, self._before = self._before, after
        if not before:
            return took
        had, wanted = (sum(max(0.0, now[n] - before.get(pid, (0, 0))[n]) for pid, now in after.items()) for n in (0, 1))
        return min(took, max(had, took - (wanted - had)))
