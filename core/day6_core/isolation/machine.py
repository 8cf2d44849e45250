"""What this machine has left, and what sets of processes take of it. Whatever is not told here is None: nothing is guessed."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from day6_core.isolation import groups
from day6_core.isolation.groups import Tree

_UNLIMITED = 1 << 60
"""A limit from here on is none: version 1 says a number of that kind."""


class Memory(NamedTuple):
    """Bytes: all that this server may use, and how much of it is free."""

    total: int
    free: int


class Taken(NamedTuple):
    """What some processes take together."""

    memory: int
    """Bytes: of what several processes share, each has its part (PSS); of one that hides that, what is its own."""
    seconds: Mapping[tuple[int, int], float]
    """What each has taken of a core so far: by its number, and when it was started."""


def memory(found: Iterable[Tree] | None = None, meminfo: str | None = None) -> Memory | None:
    """Return what there is to this process: the machine's, or less where a control group above it allows less."""
    try:
        text = Path("/proc/meminfo").read_text(encoding="ascii") if meminfo is None else meminfo
        lines = dict(line.split(":", 1) for line in text.splitlines() if ":" in line)
        total, free = (int(lines[name].split()[0]) << 10 for name in ("MemTotal", "MemAvailable"))
    except (OSError, ValueError, KeyError, IndexError):
        return None
    for most, used in _limits(groups.trees() if found is None else found):
        total, free = min(total, most), min(free, max(0, most - used))
    return Memory(total, free)


def _limits(found: Iterable[Tree]) -> Iterator[tuple[int, int]]:
    """Yield the limit of each group of memory from ours up, and what is used there."""
    for tree in found:
        if "memory" in tree.controllers:
            names = ("memory.max", "memory.current") if tree.is_v2 else _V1
            for group in (tree.own, *tree.own.parents):
                most, used = (_number(group / name) for name in names)
                if most is not None and used is not None and most < _UNLIMITED:
                    yield most, max(0, used - groups.idle_files(group, is_v2=tree.is_v2))


_V1 = ("memory.limit_in_bytes", "memory.usage_in_bytes")


def cores(found: Iterable[Tree] | None = None) -> float:
    """Return how many processors this process may fill at a time."""
    count = float(processors())
    for tree in groups.trees() if found is None else found:
        if "cpu" in tree.controllers:
            for group in (tree.own, *tree.own.parents):
                count = min(count, _quota(group, is_v2=tree.is_v2))
    return count


def processors() -> int:
    """Return how many processors this process may run on."""
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _quota(group: Path, *, is_v2: bool) -> float:
    if is_v2:
        quota, _, period = groups.read(group / "cpu.max").strip().partition(" ")
    else:
        quota, period = (groups.read(group / f"cpu.cfs_{name}_us").strip() for name in ("quota", "period"))
    return int(quota) / int(period) if quota.isdigit() and period.isdigit() and int(period) else float("inf")


def _number(file: Path) -> int | None:
    text = groups.read(file).strip()
    return int(text) if text.isdigit() else None


def taken(pids: Iterable[int]) -> Taken:
    """Measure what these processes take. A few milliseconds each: not for an event loop's thread."""
    if sys.platform == "win32":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    memory, seconds = 0, {}
    for pid in pids:
        try:
            with open(f"/proc/{pid}/stat", "rb") as file:
                fields = file.read().rpartition(b")")[2].split()  # the name before it may hold anything
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
        return own_memory(pid)


def own_memory(pid: int) -> int:
    """Return the bytes of a process that it does not share with a file, 0 for one that has ended."""
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    try:
        with open(f"/proc/{pid}/statm", encoding="ascii") as file:
            _, resident, shared, *_ = map(int, file.read().split())
    except (OSError, ValueError):
        return 0
    return (resident - shared) * os.sysconf("SC_PAGE_SIZE")


def share(before: Taken, now: Taken, seconds: float) -> float:
    """Return what was taken of a core in the time between: 1.0 is a whole one. What ended meanwhile is not known any more."""
    spent = sum(taken - before.seconds.get(process, 0.0) for process, taken in now.seconds.items())
    return max(0.0, spent / seconds) if seconds > 0 else 0.0
