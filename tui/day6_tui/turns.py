"""Short turns on the processor, for what has to answer soon: on a busy machine a key waits for one at each step of its way.

Linux (6.12 and later) lets a thread ask for turns shorter than usual. It gets no more of the processor, but gets it sooner after
it has waited. No rights are needed for that, nor for taking it back. Elsewhere nothing happens.
"""

from __future__ import annotations

import contextlib
import os
import struct
import sys
from collections.abc import Iterable

SHORT_NS = 100_000
"""The shortest turn there is: long enough to pass a key or a frame on."""

LASTING_SECONDS = 5.0
"""How long after the last key a desktop's turns are short."""

_SYSTEM_CALL = {"x86_64": 314, "aarch64": 274, "riscv64": 274}
"""The number of sched_setattr."""
_ATTRIBUTES = struct.Struct("=IIQiIQQQII")
"""Of struct sched_attr: size, policy, flags, nice value, priority, turn, deadline, period, two limits of use."""


def take_short(threads: Iterable[int] = (0,), nanoseconds: int = SHORT_NS) -> None:
    """Give threads, by their system-wide numbers (0: this one), turns of this length; 0 for the usual one.

    What they start has the same, unless `keep_from_children` was called before.
    """
    if sys.platform == "linux" and (number := _SYSTEM_CALL.get(os.uname().machine)) is not None:
        import ctypes

        library = ctypes.CDLL(None)
        for thread in threads:
            with contextlib.suppress(OSError):
                policy = os.sched_getscheduler(thread)
                nice = os.getpriority(os.PRIO_PROCESS, thread)
                if policy & ~os.SCHED_RESET_ON_FORK == os.SCHED_OTHER:
                    flags = int(bool(policy & os.SCHED_RESET_ON_FORK))
                    wanted = _ATTRIBUTES.pack(_ATTRIBUTES.size, os.SCHED_OTHER, flags, nice, 0, nanoseconds, 0, 0, 0, 0)
                    library.syscall(number, thread, wanted, 0)


def keep_from_children(threads: Iterable[int] = (0,)) -> None:
    """What these threads start has usual turns, whatever theirs are."""
    if sys.platform == "linux":
        for thread in threads:
            with contextlib.suppress(OSError):
                if (
                    os.sched_getscheduler(thread) == os.SCHED_OTHER
                ):  # else it is so already, or the user chose otherwise
                    os.sched_setscheduler(thread, os.SCHED_OTHER | os.SCHED_RESET_ON_FORK, os.sched_param(0))


class Turns:
    """Those of a desktop's threads: short from a key on for a while."""

    def __init__(self) -> None:
        self._threads: set[int] = set()
        """Those with short turns."""

    def typed(self, threads: Iterable[int]) -> None:
        """A key was read: it goes through these threads. Any thread."""
        if new := set(threads) - self._threads:
            keep_from_children(new)
            take_short(new)
            self._threads |= new

    def rest(self) -> None:
        """Nobody types any more."""
        if self._threads:
            threads, self._threads = self._threads, set()
            take_short(threads, 0)
