"""What the system says of other processes, on Linux."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import os
import select
from collections.abc import Iterator
from itertools import count
from pathlib import Path

_poll = select.poll
_restless = count(-2, -1)


def parent_of(pid: int) -> int:
    """Return the number of its parent, 0 if it is gone."""
    fields = _stat(f"/proc/{pid}/stat")
    return int(fields[1]) if fields else 0


def stirred(pid: int) -> int:
    """Return how often its threads have run so far; a number that never comes again if one runs, waits for the disk or ends now.

    Of two looks with the same number, nothing happened in between: all of it waits for something. One look isn't enough, as
    threads hand on to each other while it is taken.
    """
    times = 0
    for thread in _threads(pid):
        fields = _stat(f"{thread}/stat")
        if fields and fields[0] in "RDZX":
            return next(_restless)
        times += _slices(f"{thread}/schedstat")
    return times


def cpu_seconds(pid: int) -> float:
    """Return the CPU time it has used, 0 if it is gone."""
    fields = _stat(f"/proc/{pid}/stat")
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK") if fields else 0.0


def command_of(pid: int) -> str:
    """Return its command line, '' if it is gone."""
    try:
        data = Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return ""
    return data.replace(b"\0", b" ").decode(errors="replace").strip()


def group_members(group: int) -> Iterator[int]:
    """Yield the processes of a group."""
    for name in os.listdir("/proc"):
        if name.isdecimal() and (fields := _stat(f"/proc/{name}/stat")) and int(fields[2]) == group:
            yield int(name)


def is_ready(fd: int, events: int) -> bool:
    """Return whether a descriptor is ready now, or never will be."""
    poll = _poll()
    poll.register(fd, events)
    return bool(poll.poll(0))


def _threads(pid: int) -> list[str]:
    try:
        return [f"/proc/{pid}/task/{name}" for name in os.listdir(f"/proc/{pid}/task")]
    except OSError:
        return []


def _slices(path: str) -> int:
    """How often a thread was given a core; 0 if it is gone."""
    try:
        with open(path, encoding="ascii") as file:
            return int(file.read().split()[2])
    except (OSError, IndexError):
        return 0


def _stat(path: str) -> list[str]:
    """The fields behind the name, from the state on; none if it is gone."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read().rpartition(")")[2].split()
    except OSError:
        return []
