"""Whether the machine kept up: how late a world's own clock was against the wall, and how late a process beside it.

Only then is a program known to be wrong: a scenario or a wrong answer during which the world stood still is played again.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

from day6_core.virtual.surroundings import is_virtual

if TYPE_CHECKING:
    from day6_core.session.session import Session

EVERY = 0.05
"""Seconds between two looks at the clock."""

STALL = 0.5
"""Seconds that everything may stand still before a scenario does not count, if it does not say otherwise."""

STALLS = 4
"""How many times as much it may stand still in all; or for this part of its time, if that is more."""
SHARE = 0.05

OWN_SHARE = 0.6
"""The part of all cores that programs have to take for the lag to be their own."""


@dataclass
class Lag:
    """How late it was at the worst, and in all, in seconds."""

    worst: float = 0.0
    total: float = 0.0
    watched_for: float = 0.0
    """Seconds in which the clocks were compared."""

    def add(self, late: float) -> None:
        """Note how late one look came."""
        self.worst, self.total = max(self.worst, late), self.total + late

    @contextmanager
    def watched(self, session: Session) -> Iterator[None]:
        """Compare the world's clock with the wall's inside this. In virtual time there is nothing to compare: it waits."""
        if is_virtual():
            yield
            return
        watch, began = session.spawn(self.watch(session)), time.monotonic()
        try:
            yield
        finally:
            watch.cancel()
            self.watched_for += time.monotonic() - began

    def stood_still(self, stall: float = STALL) -> float:
        """The longest time for which the world stood still while it was watched; 0 if it kept up, see `worst_of`."""
        return worst_of(self.watched_for, self, stall=stall)

    async def watch(self, session: Session) -> None:
        """Compare them until this is cancelled."""
        while True:
            began = time.monotonic()
            await session.sleep(EVERY)
            self.add(max(0.0, time.monotonic() - began - EVERY))


def worst_of(seconds: float, world: Lag, beside: Iterable[float] = (), cpu: float = 0.0, stall: float = STALL) -> float:
    """The longest time for which what took `seconds` stood still; 0 if it kept up, or if its own programs held up the machine.

    `beside` is how late other processes were meanwhile, `cpu` how many seconds of the cores its programs took, `stall` how long
    it may stand still.
    """
    own = OWN_SHARE * cores() * seconds
    other = Lag()
    for late in beside:
        other.add(late)
    most = max(STALLS * stall, SHARE * seconds)
    lagged = any(each.worst > stall or each.total > most for each in (world, other))
    return round(max(world.worst, other.worst), 2) if lagged and cpu < own else 0.0


def cores() -> int:
    """How many of the machine's cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
