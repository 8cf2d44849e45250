"""What sets of processes take of this machine."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from day6_core.system.processes import own_memory, stat_fields


class Taken(NamedTuple):
    """What some processes take together."""

    memory: int
    """Bytes: of what several processes share, each has its part (PSS); of one that hides that, what is its own."""
    seconds: Mapping[tuple[int, int], float]
    """What each has taken of a core so far: by its number, and when it was started."""


def taken(pids: Iterable[int]) -> Taken:
    """Measure what these processes take. A few milliseconds each: not for an event loop's thread."""
    if sys.platform == "win32":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    memory, seconds = 0, {}
    for pid in pids:
        try:
            fields = stat_fields(pid)
            seconds[pid, int(fields[19])] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
            memory += _pss(pid)
        except (OSError, ValueError, IndexError):
            continue  # it has ended
    return Taken(memory, seconds)


def _pss(pid: int) -> int:
    try:
        with open(f"/proc/{pid}/smaps_rollup", "rb") as file:
            return next((int(line.split()[1]) << 10 for line in file if line.startswith(b"Pss:")), 0)
    except OSError:
        return own_memory([pid])


def share(before: Taken, now: Taken, seconds: float) -> float:
    """Return what was taken of a core in the time between: 1.0 is a whole one. What ended meanwhile is not known any more."""
    spent = sum(taken - before.seconds.get(process, 0.0) for process, taken in now.seconds.items())
    return max(0.0, spent / seconds) if seconds > 0 else 0.0
