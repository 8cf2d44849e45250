"""Ends what takes more memory than it may where the system itself can't hold it to that (macOS).

RLIMIT_DATA and RLIMIT_AS do nothing there before macOS 12, and bound the address space since then, of which any process
reserves more than the machine has memory (xnu, osfmk/vm/vm_map.c, vm_map_enter). So what is resident is measured; what macOS
has compressed is not seen.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Collection, Iterable
from typing import Protocol

from day6_core.shell.process.memory import is_held_by_system, memory_limit
from day6_core.system.processes import ProcessEntry, family, processes

EVERY = 1.0
"""Seconds between two looks; each starts `ps`."""


class Watched(Protocol):
    """A program that was started here."""

    @property
    def pid(self) -> int: ...

    def end_for_memory(self, pid: int, limit: int) -> None:
        """Kill one of its processes, and say why."""


class MemoryWatch:
    """A thread that looks at the memory of `running` programs, as long as there are any."""

    def __init__(self, running: Callable[[], Iterable[Watched]]) -> None:
        self._running = running
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None

    def begin(self) -> None:
        """A program was started."""
        if is_held_by_system() or not memory_limit():
            return
        with self._lock:
            if self._thread is None:
                self._thread = threading.Thread(target=self._run, name="day6-memory", daemon=True)
                self._thread.start()

    def _run(self) -> None:
        while True:
            time.sleep(EVERY)
            with self._lock:
                if not self._running():
                    self._thread = None
                    return
            self.look()

    def look(self) -> None:
        """End the largest process of each program, if it is too large."""
        table, limit = processes(), memory_limit()
        for program in self._running():
            pid = too_large(table, program.pid, limit)
            if pid is not None:
                program.end_for_memory(pid, limit)


def too_large(table: Collection[ProcessEntry], program: int, limit: int) -> int | None:
    """Return the largest process of a program if it has more than `limit` bytes: of its group, or below it."""
    below = {program, *family(table, [program])}
    its = [each for each in table if program and (each.pid in below or each.group == program) and not each.is_dead]
    largest = max(its, key=lambda each: each.resident, default=None)
    return largest.pid if largest is not None and largest.resident > limit > 0 else None
