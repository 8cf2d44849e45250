"""What the system says of other processes, on Linux."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import os
import select
import time
from collections.abc import Container, Iterator
from itertools import count
from pathlib import Path

from day6_core.virtual.surroundings import identity

_poll, _sleep = select.poll, time.sleep
_LOOKS_FOR_STOPPED = 200
_restless = count(-2, -1)
_WAITING_FOR_INPUT = (
    *("pipe_read", "anon_pipe_read", "pipe_wait", "pipe_wait_readable"),
    *("n_tty_read", "unix_stream_data_wait", "unix_stream_read_generic"),
)
"""Where Linux says that a thread waits which reads from a pipe, a terminal or a Unix socket. Not wait_woken: TCP waits there."""
_WAITING_FOR_ROOM = (
    *("pipe_write", "anon_pipe_write", "pipe_wait_writable"),
    *("n_tty_write", "unix_stream_sendmsg", "sock_alloc_send_pskb", "sock_wait_for_wmem"),
)
"""The same for one that writes, and nobody has read what it has written."""
_WAITING_FOR_A_CHILD = "do_wait"
_WAITING_FOR_A_THREAD = ("futex_do_wait", "futex_wait_queue", "futex_wait_queue_me")
"""Where the threads of a program of Python wait that haven't got their turn."""


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
        times += _scheduled(f"{thread}/schedstat")[2]
    return times


def used(pid: int) -> tuple[float, float]:
    """Return for how many seconds its threads have had a core, and for how many they have wanted one."""
    had = wanted = 0.0
    for thread in _threads(pid):
        cpu, waited, _ = _scheduled(f"{thread}/schedstat")
        had += cpu / 1e9
        wanted += (cpu + waited) / 1e9
    return had, wanted


def tree_stirred(pid: int, known: Container[int]) -> int:
    """The same of a process and those that it has started, but for those that are known."""
    times = stirred(pid)
    for child in _children(pid):
        if times >= 0 and child not in known:
            more = tree_stirred(child, known)
            times = times + more if more >= 0 else more
    return times


def tree(pid: int) -> list[int]:
    """Return a process and all that it has started and they have."""
    found = [pid]
    for each in found:
        found += _children(each)
    return found


def parent_of(pid: int) -> int:
    """Return who has started a process, 0 if it is gone."""
    fields = _stat(f"/proc/{pid}/stat")
    return int(fields[1]) if fields else 0


def started_at(pid: int) -> int:
    """Return when a process was started, in ticks since the machine was, 0 if it is gone."""
    fields = _stat(f"/proc/{pid}/stat")
    return int(fields[19]) if len(fields) > 19 else 0


def tree_waits_for_others(pid: int, known: Container[int], outside: str) -> bool:
    """Return whether a process, and those that it has started, wait for what others write or read, or for each other's end.

    Those that are known are left out. What is read from `outside` (an identity) doesn't count, nor does a terminal or pipe where
    the system doesn't say for what a process waits.
    """
    places = {_read(f"{thread}/wchan").strip("\0") for thread in _threads(pid)}.difference(_WAITING_FOR_A_THREAD)
    if not places or not places.issubset((_WAITING_FOR_A_CHILD, *_WAITING_FOR_INPUT, *_WAITING_FOR_ROOM)):
        return False
    if places.intersection(_WAITING_FOR_INPUT) and identity(f"/proc/{pid}/fd/0") == outside:
        return False
    return all(child in known or tree_waits_for_others(child, known, outside) for child in _children(pid))


def is_stopped_soon(pid: int) -> bool:
    """Return whether a process that was sent a signal to stop does so. It takes effect when the process next has a core."""
    for _ in range(_LOOKS_FOR_STOPPED):
        fields = _stat(f"/proc/{pid}/stat")
        if not fields or fields[0] in "TtZX":
            return bool(fields) and fields[0] in "Tt"
        _sleep(0.001)
    return False


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


def _children(pid: int) -> list[int]:
    return [int(child) for thread in _threads(pid) for child in _read(f"{thread}/children").split()]


def _scheduled(path: str) -> list[int]:
    """For how long a thread had a core and waited for one, ns, and how often; zeros if it is gone."""
    fields = _read(path).split()
    return [int(field) for field in fields] if len(fields) == 3 else [0, 0, 0]


def _stat(path: str) -> list[str]:
    """The fields behind the name, from the state on; none if it is gone."""
    return _read(path).rpartition(")")[2].split()


def _read(path: str) -> str:
    """The text of a file, '' if there is none any more."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read()
    except OSError:
        return ""
