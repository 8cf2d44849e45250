"""Waiting for what real processes and threads do: look again and again, until a deadline that only a defect reaches."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable, Sequence
from contextlib import suppress
from time import monotonic, sleep  # by name: some tests step `time.monotonic`, and most may not sleep (`one_process`)
from typing import Any, TypeVar

T = TypeVar("T")

PATIENCE = 30.0
"""Seconds something may take, on the clock of `Deadline`; nothing waits that long unless it is broken."""

LONGEST_LOOK = 1.0
"""Seconds that one look at the clock counts at most: what looks hundreds of times a second and misses more was itself stopped."""

_CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Deadline:
    """Ends after `limit` seconds of a core: its clock goes as fast as one more program would get on here.

    With three programs that want to run on one core, it goes at a third of the wall's speed, so that a busy machine makes a test
    slow but not red. Where the system does not tell how many want to run (`/proc/loadavg` of Linux), it is the wall's clock. Time
    in which the whole machine stood still, a virtual one that is moved to another host for instance, does not count.
    """

    def __init__(self, limit: float = PATIENCE) -> None:
        self._left = limit
        self._last = monotonic()

    def is_over(self) -> bool:
        """Look at the clock; it has to be asked more often than the load changes."""
        now = monotonic()
        self._left -= min(now - self._last, LONGEST_LOOK) * share_of_a_core()
        self._last = now
        return self._left < 0


def share_of_a_core() -> float:
    """How much of a core a program that wants to run gets at this moment: less than 1 where too many want to run."""
    try:
        with open("/proc/loadavg", encoding="ascii") as file:
            wanting = int(file.read().split()[3].partition("/")[0])
    except (OSError, ValueError, IndexError):
        return 1.0
    return min(1.0, _CORES / max(1, wanting))


def until(
    condition: Callable[[], T],
    limit: float = PATIENCE,
    *,
    every: float = 0.005,
    meanwhile: Callable[[], object] | None = None,
    told: Callable[[], object] | None = None,
) -> T:
    """Ask until the answer is true and return it; AssertionError, with what `told` returns, when it never is.

    Between two looks `meanwhile` is called (it moves a stepped clock on, or runs a scheduler), and then `every` seconds pass.
    """
    deadline = Deadline(limit)
    while not (answer := condition()):
        if deadline.is_over():
            raise AssertionError(f"after {limit} s the answer is still {answer!r}; {told() if told else ''}")
        if meanwhile is not None:
            meanwhile()
        sleep(every)
    return answer


def communicate(process: subprocess.Popen[Any], given: Any = None, limit: float = PATIENCE) -> tuple[Any, Any]:
    """Do what `Popen.communicate` does; a process that does not end is killed, and AssertionError tells what it wrote."""
    deadline = Deadline(limit)
    while True:
        with suppress(subprocess.TimeoutExpired):
            return process.communicate(given, timeout=0.2)
        given = None  # it goes on with what it was given
        if deadline.is_over():
            process.kill()
            raise AssertionError(f"after {limit} s it still runs: {process.args!r}", process.communicate())


def run(command: Sequence[Any], given: Any = None, limit: float = 2 * PATIENCE, **options: Any) -> Any:
    """Do what `subprocess.run` does, with both streams captured, in UTF-8 unless `text` says otherwise."""
    pipes: dict[str, Any] = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    if options.setdefault("text", True):
        options.setdefault("encoding", "utf-8")
    with subprocess.Popen(command, **{**pipes, **options}) as process:
        return subprocess.CompletedProcess(command, *_result(process, given, limit))


def _result(process: subprocess.Popen[Any], given: Any, limit: float) -> tuple[int, Any, Any]:
    printed = communicate(process, given, limit)
    return process.returncode, *printed
