"""Virtual time at a pace, for a world in which a person takes part: the desktop is its first process.

Time goes on as fast as the person wants: as in the real world, slower, faster, as fast as it can, or not at all. What comes from
outside, such as a key, doesn't hold time still; it is handled at the moment of the world that corresponds to now.

The person's own time is the real one. So the threads that draw and take keys (`in_real_time`) have real clocks, and wait in
real time; all the same they have their turns among the others, and see the world at a moment of its own. They have theirs also
while another process computes, so that the picture stays alive.
"""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import _thread
import heapq
import select
import threading
import time
from collections.abc import Callable
from itertools import count
from typing import Any

from day6_core.virtual import surroundings
from day6_core.virtual.coordinator import PATIENCE, Coordinator, _Process
from day6_core.virtual.follow.builtin import put
from day6_core.virtual.follow.clocks import EPOCH_NS
from day6_core.virtual.kernel import FOR_EVER_NS, Kernel, Wait, Watch
from day6_core.virtual.wire import NEVER, Flag

_poll = select.poll
_get_ident = _thread.get_ident
_real_ns = time.monotonic_ns
_real_clocks: dict[str, Callable[[], float]] = {"monotonic": time.monotonic, "perf_counter": time.perf_counter}

MOST_LAG_NS = 250_000_000
"""Real time: a world that is further behind, because it has more to compute, doesn't catch up."""

LONG_TURN_NS = 1_000_000_000
"""Real time: a process that computes for longer no longer has the world for itself."""


class PacedKernel(Kernel):
    """A kernel some of whose threads live in real time."""

    def __init__(self) -> None:
        super().__init__()
        self.people: dict[int, Wait] = {}
        """The threads that do, by their numbers."""
        self.alone = False
        """Whether another process runs, so that only these may look at what has come."""
        self._alarms: list[tuple[int, int, Wait]] = []
        self._alarm_numbers = count()

    def in_real_time(self) -> None:
        """The calling thread lives in real time from now on."""
        self.people[_get_ident()] = self.mine()

    def clock(self) -> int:
        """Read the clock, ns; what people read doesn't let time pass, as they may read at any moment."""
        return self.now if _get_ident() in self.people else super().clock()

    def wait(self, ns: int | None = None, watch: Watch | None = None) -> bool:
        """As there, in real time for those who live in it."""
        if ns is None or ns >= FOR_EVER_NS or (mine := self.people.get(_get_ident())) is None:
            return super().wait(ns, watch)
        alarm = (_real_ns() + max(0, ns), next(self._alarm_numbers), mine)
        heapq.heappush(self._alarms, alarm)
        try:
            return super().wait(None, watch)
        finally:
            if alarm in self._alarms:
                self._alarms.remove(alarm)
                heapq.heapify(self._alarms)

    def end(self) -> None:
        """End the calling thread."""
        self.people.pop(_get_ident(), None)
        super().end()

    @property
    def alarm(self) -> int | None:
        """The first moment in real time for which a thread waits, ns."""
        return self._alarms[0][0] if self._alarms else None

    def wake_people(self) -> bool:
        """Let those go on whose time has come in reality; return whether a thread can."""
        alarms = self._alarms
        while alarms and alarms[0][0] <= _real_ns():
            wait = heapq.heappop(alarms)[2]
            if wait.waiting and not wait.woken:
                wait.late = True
                self._queue(wait)
        return self.has_turn

    def look(self) -> bool:
        """Look for what threads watch; return whether one can go on."""
        if not self.alone:
            return super().look()
        watching, touched = self._watching, self.touched
        self._watching = {wait: None for wait in watching if wait.ident in self.people}
        try:
            return super().look()
        finally:
            self._watching, self.touched = watching, touched

    def forked(self) -> None:
        """In the child of a fork, nobody is a person."""
        super().forked()
        self.people.clear()
        self._alarms.clear()
        self.alone = False


class PacedCoordinator(Coordinator):
    """The coordinator of such a world. All but what it overrides is for the threads of people to call."""

    _holding = 0
    _longest_patience = 2 * PATIENCE

    def __init__(self, path: str, tell: Callable[[str, str], None]) -> None:
        super().__init__(path, tell)
        self.speed = 1.0
        """Seconds of the world in a real one; infinity is as fast as it can."""
        self.paused = False
        self._has_begun = False
        self._since = (_real_ns(), 0)
        """A moment in reality, and the one of the world that corresponds to it."""
        self._went_at = 0
        """When another process had its turn or began, in real ns."""
        self.replays = False
        """Whether what was is played again: as fast as it can, whatever speed and pause are meanwhile."""
        self.waits = False
        """Whether the world waits for the picture meanwhile."""
        self._steps_to = 0
        """Until then, time goes on although it is paused."""
        self.people: Callable[[], None]
        """Has the calling thread live in real time."""
        self.sleep_until: Callable[[int], object]
        """Has the calling thread, which lives in the world's time, wait for a moment, without a look at a clock."""
        self.say: Callable[[str], None] | None = None
        """Says a sentence to the person. From any thread, also one that takes no part."""

    # -- for people --------------------------------------------------------------------------------------------------------

    @property
    def now(self) -> int:
        """The time of the world, ns since it began."""
        return self._now

    def begin(self) -> None:
        """Let time pass from now on: all that was to be there when the world begins is."""
        self._rebase()
        self._has_begun = True

    def set_speed(self, speed: float) -> None:
        """Let time pass at this speed from now on."""
        self._rebase()
        self.speed = speed

    def pause(self) -> None:
        """Let no time pass until `resume`."""
        self.paused = True
        self._steps_to = 0

    def resume(self) -> None:
        """Let time pass again."""
        self.begin()
        self.paused = False

    def step(self, seconds: float) -> None:
        """Let so much time pass while it is paused, at once."""
        self._steps_to = max(self._steps_to, self._now) + int(seconds * 1e9)

    # -- how it passes -------------------------------------------------------------------------------------------------------

    def _rebase(self) -> None:
        self._since = (_real_ns(), self._now)

    def _lag(self, moment: int) -> float:
        """How long ago, in real ns, a moment of the world ought to have been; negative while it is to come."""
        real, virtual = self._since
        return _real_ns() - real - (moment - virtual) / self.speed

    def _pass(self, kernel: Kernel) -> bool:
        if self._has_stirred():
            return True
        first = self._next_moment()
        if first is None:
            self._rebase()  # time stands still, and doesn't catch up
            return False
        if self.waits or not self._has_begun or (self.paused and not self.replays):
            if self._steps_to <= self._now:
                self._attend(kernel, self._at_most(None))
            elif NEVER != first <= self._steps_to:
                self._pass_to(first)
            else:
                self._pass_to(self._steps_to)
            return True
        if first == NEVER and (self.replays or self.speed == float("inf")):
            return False
        lag = -float("inf") if first == NEVER else 0.0 if self.replays else self._lag(first)
        if lag < 0:
            self._attend(kernel, self._at_most(None if first == NEVER else -lag / 1e9))
            now = int(self._since[1] + (_real_ns() - self._since[0]) * self.speed)
            self._advance(now if first == NEVER else min(first, now))
            return True
        if lag > MOST_LAG_NS:
            self._since = (_real_ns(), first)
        self._pass_to(first)
        return True

    def _at_most(self, seconds: float | None) -> float | None:
        """How long to wait at most, where something real may go on without telling."""
        if not any(each.is_real for each in self._members.values()):
            return seconds
        return 4 * PATIENCE if seconds is None else min(seconds, 4 * PATIENCE)

    # -- what people get meanwhile -------------------------------------------------------------------------------------------

    def _is_own_turn(self, kernel: Kernel) -> bool:
        assert isinstance(kernel, PacedKernel)
        if kernel.wake_people():
            return True
        if kernel.alone:
            kernel.alone = any(each.runs and not each.is_real for each in self._members.values())
        return kernel.look() if kernel.alone else super()._is_own_turn(kernel)

    def spawned(self, pid: int) -> None:
        """A process was started; time stands still before it takes part or ends."""
        super().spawned(pid)
        self._went_at = _real_ns()

    def _go(self, member: _Process) -> None:
        super()._go(member)
        self._went_at = _real_ns()

    def _turns_to_people(self, kernel: Kernel) -> bool:
        assert isinstance(kernel, PacedKernel)
        # What a program writes before it computes for long is to be seen.
        kernel.alone = _real_ns() - self._went_at < LONG_TURN_NS
        found = kernel.look() or kernel.wake_people()
        kernel.alone = kernel.alone and found
        return found

    def _attend(self, kernel: Kernel, seconds: float | None) -> bool:
        assert isinstance(kernel, PacedKernel)
        if kernel.alarm is not None:
            left = max(0.0, (kernel.alarm - _real_ns()) / 1e9)
            seconds = left if seconds is None else min(seconds, left)
        return super()._attend(kernel, seconds)

    def _hears_alone(self, member: _Process) -> bool:
        return bool(member.flags & Flag.HOLDS)


def install(kernel: PacedKernel, pace: PacedCoordinator) -> None:
    """Give the threads that live in real time real clocks. After all others have been put in place."""
    people = kernel.people

    def reading(real: Callable[[], float], virtual: Callable[[], float]) -> Callable[[], float]:
        return lambda: real() if _get_ident() in people else virtual()

    for name, clock in _real_clocks.items():
        put(time, **{name: reading(clock, getattr(time, name))})
    put(time, time_ns=lambda: EPOCH_NS + kernel.clock(), monotonic_ns=lambda: kernel.clock())
    threads: Any = threading
    threads._time = time.monotonic
    pace.people = kernel.in_real_time
    pace.sleep_until = lambda moment: kernel.wait(max(0, moment - kernel.now))
    surroundings.pace = pace
