"""What tells a thread that is stuck from one that a busy machine lets wait: how long it was ready to run while others ran."""

from __future__ import annotations

import threading
import time

from day6_core.virtual.surroundings import is_virtual


def waited_for_a_core(thread: int) -> float:
    """Seconds in which a thread of this process, by its system-wide number, was ready to run and got no core.

    The second number of Linux's schedstat (its Documentation/scheduler/sched-stats.rst); 0 where the system does not tell, and in
    virtual time, of which nothing passes meanwhile.
    """
    if is_virtual():
        return 0.0
    try:
        with open(f"/proc/self/task/{thread}/schedstat", encoding="ascii") as file:
            return int(file.read().split()[1]) / 1e9
    except (OSError, ValueError, IndexError):
        return 0.0


def idle_seconds() -> float:
    """A clock that goes only while the calling thread has nothing to do: neither while it runs nor while it could."""
    return time.monotonic() - time.thread_time() - waited_for_a_core(threading.get_native_id())


class Allowance:
    """Seconds that a thread is given; those in which it waits for a core do not count."""

    def __init__(self, seconds: float, thread: threading.Thread) -> None:
        self._thread = thread.native_id or 0
        self._end = time.monotonic() + seconds - waited_for_a_core(self._thread)

    def left(self) -> float:
        """What is left of them; not more than 0 once they are over."""
        return self._end + waited_for_a_core(self._thread) - time.monotonic()


def join(thread: threading.Thread, seconds: float) -> None:
    """Wait for the end of a thread, which is given so many seconds, see `Allowance`."""
    allowance = Allowance(seconds, thread)
    while thread.is_alive() and (left := allowance.left()) > 0:
        thread.join(left)
