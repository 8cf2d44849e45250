"""Keeps one judge and everything that it starts apart from the rest of the machine and inside its limits.

On Linux, where the system lets a user make namespaces, the judge lives in its own: it sees and can kill only its own
processes, all of them end with the first one (no `setsid` or double fork leads out), it has no network, and the whole
machine is read-only but for a folder in memory of a limited size. Elsewhere the processes are found by their parents and
their mark and ended one by one; whoever is there is told that this is weaker (`Shield.NONE`).
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import select
import signal
import struct
import sys
import time
from collections.abc import Callable, Iterable
from enum import Enum
from pathlib import Path
from typing import Any

from day6_core.guardian import MARK
from day6_core.reason import named_reason
from day6_core.system.processes import descendants, divided_memory, marked, own_memory, processes, stat_fields
from day6_core.virtual.surroundings import is_there

MOST_PROCESSES = 120
MOST_MEMORY = 2 * 2**30
"""Bytes in memory that all processes of a submission may have together."""

MOST_DISK = 256 * 2**20
LARGEST_FILE = 64 * 2**20
LOOK_SECONDS = 0.15

fork: Any = getattr(os, "fork", None)  # not on Windows
waitpid: Any = getattr(os, "waitpid", None)
_kill, _open, _select = os.kill, open, select.select
_monotonic, _sleep = time.monotonic, time.sleep
"""For what the warden does: it goes by the real time, although its judges may be in another; see there."""

_NEW_USER, _NEW_NS, _NEW_PID, _NEW_NET, _NEW_IPC = 0x10000000, 0x00020000, 0x20000000, 0x40000000, 0x08000000
_REC, _PRIVATE, _BIND, _NO_SUID, _NO_DEV = 0x4000, 1 << 18, 0x1000, 2, 4
_DEATH, _DUMPABLE, _NO_NEW_PRIVILEGES, _SUBREAPER = 1, 4, 38, 36
_MOUNT_SETATTR, _RECURSIVE, _READ_ONLY = 442, 0x8000, 1
_INSIDE = 1000
"""The user's number inside: not 0, so that nobody there has a right that the user has not."""


class Shield(Enum):
    """How well programs are kept apart."""

    WHOLE = "whole"
    NONE = "none"


class Unshielded(Exception):
    """The system does not let us make namespaces."""


def _prctl(option: int, value: int) -> None:
    ctypes.CDLL(None, use_errno=True).prctl(option, value, 0, 0, 0)


def hide(hidden: bool = True) -> None:
    """Let no other process of this user look into this one: not its memory, its environment, its open files; or let it again."""
    if sys.platform == "linux":
        _prctl(_DUMPABLE, 0 if hidden else 1)


def end_with_parent() -> None:
    """Be killed when the process that started this one is gone."""
    if sys.platform == "linux":
        _prctl(_DEATH, signal.SIGKILL)


def adopt_orphans() -> None:
    """Become the parent of what descendants leave behind."""
    if sys.platform == "linux":
        _prctl(_SUBREAPER, 1)


def give_up_root(user: int, work: Path) -> None:
    """Be this user for good, who has nothing but `work`: what root may do, no namespace takes away from its files and devices."""
    if sys.platform == "linux":
        os.chown(work, user, user)
        os.setgroups([])
        os.setresgid(user, user, user)
        os.setresuid(user, user, user)
        _prctl(_DUMPABLE, 1)  # as a new program is: what /proc has of it is its own
        end_with_parent()  # once more: who becomes another has forgotten it


# -- namespaces --------------------------------------------------------------------------------------------------------


def enter(work: Path, hidden: Iterable[str] = ()) -> int:
    """Make namespaces; returns 0 in the first process inside and its number in the one outside, which has to wait for it.

    `work` is the one folder that can be written to inside; what is `hidden` is empty. Only for a process with one thread.
    Raises Unshielded.
    """
    if sys.platform != "linux":
        raise Unshielded("there are no namespaces on this system")
    libc = ctypes.CDLL(None, use_errno=True)
    user, group = os.getuid(), os.getgid()
    if libc.unshare(_NEW_USER | _NEW_NS | _NEW_PID | _NEW_NET | _NEW_IPC):
        raise Unshielded(f"unshare: {os.strerror(ctypes.get_errno())}")
    try:
        Path("/proc/self/setgroups").write_text("deny", encoding="ascii")
        Path("/proc/self/gid_map").write_text(f"{_INSIDE} {group} 1", encoding="ascii")
        Path("/proc/self/uid_map").write_text(f"{_INSIDE} {user} 1", encoding="ascii")
        _mount(libc, "none", "/", "", _REC | _PRIVATE)
    except OSError as error:
        raise Unshielded(f"user namespace: {named_reason(error)}") from None
    reading, writing = os.pipe()
    child: int = fork()
    if child:
        os.close(writing)
        with _open(reading, "rb") as answer:
            problem = answer.read()
        if problem:
            waitpid(child, 0)
            raise Unshielded(problem.decode())
        return child
    os.close(reading)
    end_with_parent()
    try:
        _furnish(libc, work, hidden)
    except OSError as error:
        os.write(writing, named_reason(error).encode())
        os._exit(1)
    os.close(writing)
    return 0


def _furnish(libc: ctypes.CDLL, work: Path, hidden: Iterable[str]) -> None:
    """Mount what the first process inside needs: its own /proc, one folder to write to, all others read-only."""
    attributes = struct.pack("=QQQQ", _READ_ONLY, 0, 0, 0)
    if libc.syscall(_MOUNT_SETATTR, -100, b"/", _RECURSIVE, attributes, len(attributes)):
        raise OSError(ctypes.get_errno(), f"mount_setattr: {os.strerror(ctypes.get_errno())}")
    for path in filter(os.path.exists, hidden):  # what this user cannot get to is closed already
        if os.path.isdir(path):
            _mount(libc, "tmpfs", path, "tmpfs", _NO_SUID | _NO_DEV, "size=4k,mode=0")
        else:
            _mount(libc, os.devnull, path, "", _BIND)
    _mount(libc, "proc", "/proc", "proc", _NO_SUID | _NO_DEV)
    _mount(libc, "tmpfs", str(work), "tmpfs", _NO_SUID | _NO_DEV, f"size={MOST_DISK},mode=0700")
    if os.path.isdir("/dev/shm"):
        _mount(libc, "tmpfs", "/dev/shm", "tmpfs", _NO_SUID | _NO_DEV, f"size={LARGEST_FILE}")
    _bring_up_loopback()


def _mount(libc: ctypes.CDLL, source: str, target: str, kind: str, flags: int, data: str = "") -> None:
    options = data.encode() or None
    if libc.mount(source.encode(), os.fsencode(target), kind.encode() or None, ctypes.c_ulong(flags), options):
        raise OSError(ctypes.get_errno(), f"mount {target}: {os.strerror(ctypes.get_errno())}")


def _bring_up_loopback() -> None:
    """Some programs talk to themselves over 127.0.0.1; without it they fail in a way that a pupil never saw."""
    if sys.platform != "linux":
        return
    import fcntl
    import socket

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one, contextlib.suppress(OSError):
        fcntl.ioctl(one, 0x8914, struct.pack("16sh14x", b"lo", 1))


# -- limits ------------------------------------------------------------------------------------------------------------


def limit(seconds: float) -> None:
    """Limit this process and those that it starts, each by itself, in what the system can limit."""
    if sys.platform == "win32":
        return
    import resource

    if sys.platform == "linux":
        _prctl(_NO_NEW_PRIVILEGES, 1)
    time_limit = int(seconds) + 5
    for kind, most in (
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_CPU, time_limit),
        (resource.RLIMIT_FSIZE, LARGEST_FILE),
        (resource.RLIMIT_DATA, MOST_MEMORY),
    ):
        with contextlib.suppress(OSError, ValueError):
            hard = resource.getrlimit(kind)[1]
            resource.setrlimit(kind, (most, most) if hard == resource.RLIM_INFINITY else (min(most, hard), hard))


def watch(
    child: int,
    seconds: float,
    processes: Callable[[], list[int]],
    late: Callable[[float], object],
    *,
    own_seconds: bool = False,
    inherited: int = 0,
) -> str:
    """Wait for `child` and reap everybody; returns '' when it ended, or 'time', 'processes', 'memory', 'killed'.

    `processes` are those that count. `late` hears of each look for how many seconds the machine kept this process, or one of
    those, waiting for a core. What still runs afterwards is for the caller to end. `own_seconds` don't pass while they wait for a
    core that others have. `inherited` is the memory, in bytes, that they have from this process and that nobody needs for them.
    """
    if sys.platform == "win32":
        raise NotImplementedError  # nothing is graded there: `command.main` says so
    left = seconds
    before: dict[int, tuple[bool, float]] = {}
    looked = _monotonic()
    while True:
        with contextlib.suppress(ChildProcessError):
            while (found := waitpid(-1, os.WNOHANG))[0]:
                if found[0] == child:
                    return "killed" if os.WIFSIGNALED(found[1]) else ""
        if left < 0:
            return "time"
        pids = processes()
        if len(pids) > MOST_PROCESSES:
            return "processes"
        if own_memory(pids) > MOST_MEMORY + inherited and divided_memory(pids) > MOST_MEMORY + inherited:
            return "memory"
        now = {pid: _worked(pid) for pid in pids}
        took, looked = _monotonic() - looked, _monotonic()
        ran = {pid: now[pid][1] - before[pid][1] for pid in pids if pid in before}
        waited = [took - ran[pid] for pid in ran if before[pid][0] and now[pid][0]]
        runs = any(is_ready for is_ready, _ in now.values())
        left -= min(took, sum(ran.values())) if own_seconds and runs else took
        before = now
        _sleep_beside(child, LOOK_SECONDS)
        late(max(0.0, _monotonic() - looked - LOOK_SECONDS, *waited))


def _sleep_beside(child: int, seconds: float) -> None:
    """Sleep, but not when a child has ended, where the system tells of that."""
    if sys.platform == "linux" and is_there():
        with _open(os.pidfd_open(child), "rb") as end:
            _select([end], [], [], seconds)
    else:
        _sleep(seconds)


def all_processes() -> list[int]:
    """The processes of this /proc, without this one."""
    return [each.pid for each in processes() if each.pid != os.getpid()]


def followers(root: int, mark: str = "") -> list[int]:
    """The processes below `root` and those whose environment bears the mark (their parent may have ended long ago)."""
    with_mark = marked(f"{MARK}_GRADE={mark}") if mark else []
    return sorted({*descendants(root, dead=True), *with_mark} - {root, os.getpid()})


def seconds_taken() -> float:
    """For how many seconds the cores have worked for those that this process and its like have started, as far as is known."""
    if sys.platform == "win32":
        return 0.0
    import resource

    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    mark = os.environ.get(f"{MARK}_GRADE", "")
    pids = [] if sys.platform != "linux" else followers(os.getpid(), mark) if mark else all_processes()
    return used.ru_utime + used.ru_stime + sum(_worked(pid)[1] for pid in pids)


def _worked(pid: int) -> tuple[bool, float]:
    """Whether a process runs or wants to, and for how many seconds it and those it has waited for have run in all."""
    if sys.platform != "linux":
        return False, 0.0
    try:
        stat = stat_fields(pid)
        return stat[0] == b"R", sum(map(int, stat[11:15])) / os.sysconf("SC_CLK_TCK")
    except (OSError, ValueError, IndexError):
        return False, 0.0


def end_all(root: int, mark: str) -> None:
    """Kill everything below `root`: first all are stopped, so that nobody starts others while they are being counted."""
    if sys.platform == "win32":
        raise NotImplementedError
    for number in (signal.SIGSTOP, signal.SIGKILL):
        for _ in range(50):
            pids = followers(root, mark)
            for pid in pids:
                with contextlib.suppress(ProcessLookupError, PermissionError):
                    _kill(pid, number)
            with contextlib.suppress(ChildProcessError):
                while waitpid(-1, os.WNOHANG)[0]:
                    pass
            after = followers(root, mark)
            if not after or (number == signal.SIGSTOP and after == pids):
                break
