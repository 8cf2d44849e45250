"""Finds the processes of a cell and ends them, those too that left their group, their session and their parent."""

from __future__ import annotations

import contextlib
import errno
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Collection

from day6_core.system.processes import descendants, processes

END_SECONDS = 5.0
"""How long ending may take: a process in an uninterruptible wait cannot be ended by anybody."""
_PAUSE = 0.01


def of_users(uids: Collection[int]) -> dict[int, list[int]]:
    """Return the living processes of some Unix users, found in one look at all."""
    found: dict[int, list[int]] = {uid: [] for uid in uids}
    for each in processes():
        with contextlib.suppress(OSError):
            if not each.is_dead and (uid := os.stat(f"/proc/{each.pid}").st_uid) in found:
                found[uid].append(each.pid)
    return found


def of_user(uid: int) -> list[int]:
    """Return the living processes of a Unix user."""
    return of_users([uid])[uid]


def all_marked(marks: Collection[str]) -> dict[str, list[int]]:
    """Return, for each mark, our own processes that have it as a word of their command line, found in one look at all."""
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    wanted = {os.fsencode(mark): mark for mark in marks}
    found: dict[str, list[int]] = {mark: [] for mark in marks}
    for each in processes():
        with contextlib.suppress(OSError):
            if os.stat(f"/proc/{each.pid}").st_uid == os.geteuid() and not each.is_dead:
                with open(f"/proc/{each.pid}/cmdline", "rb") as file:
                    for word in wanted.keys() & set(file.read().split(b"\0")):
                        found[wanted[word]].append(each.pid)
    return found


def marked(mark: str) -> list[int]:
    """Return our own processes that have `mark` as a word of their command line."""
    return all_marked([mark])[mark]


def end_descendants(root: int) -> bool:
    """Kill everything below `root`; return whether nothing is left."""
    return _end(lambda: descendants(root))


def end_user(uid: int) -> bool:
    """Kill every process of a Unix user at once, as that user; return whether nothing is left."""

    def strike(_pids: list[int]) -> None:
        # -1 is everybody this user may kill, in one step: nothing can fork away from it. The shell kills itself, too.
        # What is the server's is not the pupil's to see: no variable, no terminal.
        subprocess.run(
            ["/bin/sh", "-c", "kill -9 -1"],
            user=uid,
            group=uid,
            extra_groups=[],
            cwd="/",
            env={},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            check=False,
        )

    return _end(lambda: of_user(uid), strike)


def end_marked(mark: str, *, gently: bool) -> bool:
    """End the processes that hold a cell, first with SIGTERM if `gently`; return whether nothing is left."""
    if gently:
        for pid in marked(mark):
            _kill(pid, signal.SIGTERM)
        until = time.monotonic() + END_SECONDS
        while marked(mark) and time.monotonic() < until:
            time.sleep(_PAUSE)
    return _end(lambda: [pid for each in marked(mark) for pid in (each, *descendants(each))])


def _end(find: Callable[[], list[int]], strike: Callable[[list[int]], None] | None = None) -> bool:
    """Kill what `find` returns until it returns nothing and all that was killed has ended."""
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    until = time.monotonic() + END_SECONDS
    # Who is ending no longer shows what he was: his number is waited for, and not killed again.
    struck: set[int] = set()
    while True:
        pids = find()
        if not pids and not _living(struck):
            return True
        if time.monotonic() >= until:
            return False
        struck.update(pids)
        if strike is None:
            for number in (signal.SIGSTOP, signal.SIGKILL):  # stopped first: a fork bomb grows no further
                for pid in pids:
                    _kill(pid, number)
        elif pids:
            strike(pids)
        time.sleep(_PAUSE)


def _living(pids: set[int]) -> list[int]:
    return [each.pid for each in processes() if each.pid in pids and not each.is_dead] if pids else []


def _kill(pid: int, number: signal.Signals) -> None:
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.kill(pid, number)
