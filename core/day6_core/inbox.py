"""A queue between threads whose reader wakes up in time."""

from __future__ import annotations

import contextlib
import math
import threading
import time
from collections import deque
from queue import Empty
from typing import Generic, TypeVar

T = TypeVar("T")


class Inbox(Generic[T]):
    """An unbounded queue that one thread reads. Any thread may put something in, and so may a signal handler at any moment.

    Up to Python 3.12, `queue.SimpleQueue.get(timeout=…)` can wait forever: if the thread loses its core inside the call for
    longer than the timeout, as happens with short ones on slow machines. `queue.Queue` isn't safe in signal handlers.
    """

    def __init__(self) -> None:
        self._items: deque[T] = deque()
        self._nothing_new = threading.Lock()
        self._nothing_new.acquire()

    def put(self, item: T) -> None:
        """Append an item and wake the reader."""
        self._items.append(item)
        if self._nothing_new.locked():
            with contextlib.suppress(RuntimeError):  # another thread has just done it
                self._nothing_new.release()

    def get(self, timeout: float | None = None) -> T:
        """Remove and return the oldest item, waiting until there is one.

        Raises:
            queue.Empty: none came within `timeout` seconds.
        """
        end = math.inf if timeout is None else time.monotonic() + timeout
        while not self._items:
            left = max(0.0, end - time.monotonic())
            if self._nothing_new.acquire(timeout=min(left, threading.TIMEOUT_MAX)) or self._items:
                continue
            if time.monotonic() >= end:
                raise Empty
        return self._items.popleft()

    def get_nowait(self) -> T:
        """Remove and return the oldest item; raise queue.Empty if there is none."""
        return self.get(0.0)

    def empty(self) -> bool:
        """Whether there are no items now."""
        return not self._items

    def qsize(self) -> int:
        """How many items there are now."""
        return len(self._items)
