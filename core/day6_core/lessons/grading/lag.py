"""Whether the machine kept up: how late a world's own clock was against the wall, and how late a process beside it.

Only then is a program known to be wrong: a scenario in which the world stood still is played again.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session

EVERY = 0.05
"""Seconds between two looks at the clock."""

WORST = 0.12
"""Seconds that a world may stand still: a turtle that a program turns by 72° a second is then as wrong as it may be."""

SHARE = 0.05
"""The part of its time that it may stand still in all."""

OWN_SHARE = 0.6
"""The part of all cores that programs have to take for the lag to be their own."""


@dataclass
class Lag:
    """How late it was at the worst, and in all, in seconds."""

    worst: float = 0.0
    total: float = 0.0

    def add(self, late: float) -> None:
        """Note how late one look came."""
        self.worst, self.total = max(self.worst, late), self.total + late

    async def watch(self, session: Session) -> None:
        """Compare the world's clock with the wall's until this is cancelled."""
        while True:
            began = time.monotonic()
            await session.sleep(EVERY)
            self.add(max(0.0, time.monotonic() - began - EVERY))


def worst_of(seconds: float, world: Lag, beside: Iterable[float], cpu: float) -> float:
    """The longest time for which a scenario stood still; 0 if it kept up, or if its own programs held up the machine.

    `beside` is how late another process was meanwhile, `cpu` how many seconds of the cores its programs took.
    """
    own = OWN_SHARE * _cores() * seconds
    other = Lag()
    for late in beside:
        other.add(late)
    lagged = any(each.worst > WORST or each.total > SHARE * seconds for each in (world, other))
    return round(max(world.worst, other.worst), 2) if lagged and cpu < own else 0.0


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
