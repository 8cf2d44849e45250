"""The pace of threads that work through what other processes and machines send."""

from __future__ import annotations

import time

_SLICE = 0.005
_PAUSE = 0.001
"""Seconds of work, and of leaving the interpreter to the program's own threads in between."""


class WorkSlices:
    """One thread's slices of work: however much there is to do, the program's threads keep running."""

    def __init__(self) -> None:
        self._end = time.monotonic() + _SLICE

    def keep(self) -> None:
        """Pause if the slice is over; to be called after each piece of work."""
        if time.monotonic() > self._end:
            time.sleep(_PAUSE)
            self._end = time.monotonic() + _SLICE
