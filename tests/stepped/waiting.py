"""Waiting for what real processes and threads do: look again and again, until a deadline that only a defect reaches."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any, TypeVar

T = TypeVar("T")

_sleep = time.sleep
"""Looking now and then is allowed where sleeping is not (`one_process`)."""

PATIENCE = 30.0
"""Seconds something may take, on the clock of `Deadline`; nothing waits that long unless it is broken."""

_CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Deadline:
    """Ends after `limit` seconds of a core: its clock goes as fast as one more program would get on here.

    With three programs that want to run on one core, it goes at a third of the wall's speed, so that a busy machine makes a test
    slow but not red. Where the system does not tell how many want to run (`/proc/loadavg` of Linux), it is the wall's clock.
    """

    def __init__(self, limit: float = PATIENCE) -> None:
        self._left = limit
        self._last = time.monotonic()

    def is_over(self) -> bool:
        """Look at the clock; it has to be asked more often than the load changes."""
        now = time.monotonic()
        self._left -= (now - self._last) * share_of_a_core()
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
        _sleep(every)
    return answer


def communicate(process: subprocess.Popen[str], said: str | None = None, limit: float = PATIENCE) -> tuple[str, str]:
    """Say this to a program and return what it printed until its end; one that does not end is killed: AssertionError."""
    deadline = Deadline(limit)
    while True:
        with suppress(subprocess.TimeoutExpired):
            return process.communicate(said, timeout=0.2)
        said = None  # it goes on with what it was given
        if deadline.is_over():
            process.kill()
            raise AssertionError(f"after {limit} s it has not ended; it printed {process.communicate()}")


def run(command: Sequence[str], limit: float = PATIENCE, **options: Any) -> subprocess.CompletedProcess[str]:
    """Run a program to its end, as `subprocess.run` that captures text."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "encoding": "utf-8"}
    with subprocess.Popen(command, **{**pipes, **options}) as process:
        return subprocess.CompletedProcess(command, *_result(process, limit))


def _result(process: subprocess.Popen[str], limit: float) -> tuple[int, str, str]:
    printed = communicate(process, limit=limit)
    return process.returncode, *printed
