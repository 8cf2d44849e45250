"""Keeps the memory of a process that lives for hours from growing, where the C library is glibc.

glibc gives threads heaps of their own. The engine of the link frees in one thread what another took, so that the holes are spread
over eight heaps a core and few can be used again: 10 to 20 kB for every program that came and went. With one heap the holes are
used again, and those that are left in it can be given back.
"""

from __future__ import annotations

import sys
import threading
import time

EVERY = 30.0
"""Seconds between two returns of memory that nobody uses, each of which takes a few milliseconds."""

_M_ARENA_MAX = -8
"""From glibc's malloc.h."""


def keep_heap_small() -> None:
    """Let all threads share one heap, and give back what is free in it, now and then. To be called before there are threads.

    Without effect where the C library has no such choice.
    """
    if not sys.platform.startswith("linux"):
        return
    import ctypes

    library = ctypes.CDLL(None)
    if not hasattr(library, "mallopt") or not hasattr(library, "malloc_trim"):
        return  # musl
    library.mallopt(_M_ARENA_MAX, 1)

    def give_back() -> None:
        while True:
            time.sleep(EVERY)
            library.malloc_trim(0)

    threading.Thread(target=give_back, name="day6-heap", daemon=True).start()
