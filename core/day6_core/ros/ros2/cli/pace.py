"""Repeats something at a rate, without taking the whole machine when the rate is too high for it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from day6_core.session.task import sleep_until

if TYPE_CHECKING:
    from day6_core.session.session import Session

SHARE = 2
"""A command gets at most half of the time: after each turn the others get as long as it took."""


class Pace:
    """Whole periods of world time from now on; longer ones where a turn takes more than half a period of wall time.

    The world clock skips no period, it falls behind wall time instead. For turtlesim that is right; but `topic pub -r 1000000`
    must not make the world stand still, and in real ROS it would not reach its rate either.
    """

    def __init__(self, session: Session, seconds: float) -> None:
        self._clock = session.clock
        self._period = max(1, round(seconds * 1e9))
        self._next = self._clock.steady_ns()
        self._woke = time.perf_counter_ns()

    async def turn(self) -> None:
        """Wait until the next period begins."""
        pause = SHARE * (time.perf_counter_ns() - self._woke)
        self._next += self._period
        if pause > self._period:
            self._next = max(self._next, self._clock.steady_ns() + pause)
        await sleep_until(self._next)
        self._woke = time.perf_counter_ns()
