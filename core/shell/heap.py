"""Keeps the memory of a process that lives for hours from growing, where the C library is glibc.

glibc gives threads heaps of their own. The engine of the link frees in one thread what another took, so that the holes are spread
over eight heaps a core and few can be used again: 10 to 20 kB for every program that came and went.
"""

from __future__ import annotations

import sys

_M_ARENA_MAX = -8
"""From glibc's malloc.h."""


def keep_one_heap() -> None:
    """Let threads that are started from now on share one heap; without effect where the C library has no such choice."""
    if not sys.platform.startswith("linux"):
        return
    import ctypes

    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)  # musl has none
    if mallopt is not None:
        mallopt(_M_ARENA_MAX, 1)
