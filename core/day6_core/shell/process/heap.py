"""Keeps the memory of a process that runs for hours from growing, if the C library is glibc.

glibc gives threads heaps of their own. The link's library frees in one thread what another allocated, so the holes are spread
over eight heaps per core and few are reused: 10 to 20 kB are lost for every program that starts and ends. With one heap the
holes are reused, and the rest can be returned to the system.
"""

from __future__ import annotations

import sys
import threading
import time

from day6_core.virtual.surroundings import in_real_time

EVERY = 30.0
"""Seconds between two returns of unused memory, each of which takes a few milliseconds."""

_M_ARENA_MAX = -8
"""From glibc's malloc.h."""


def keep_heap_small() -> None:
    """Make all threads share one heap, and return its free memory now and then. Call it before threads are started.

    Has no effect if the C library is not glibc.
    """
    if not sys.platform.startswith("linux"):
        return
    import ctypes

    library = ctypes.CDLL(None)
    if not hasattr(library, "mallopt") or not hasattr(library, "malloc_trim"):
        return  # musl
    library.mallopt(_M_ARENA_MAX, 1)

    def give_back() -> None:
        in_real_time()
        while True:
            time.sleep(EVERY)
            library.malloc_trim(0)

    threading.Thread(target=give_back, name="day6-heap", daemon=True).start()
