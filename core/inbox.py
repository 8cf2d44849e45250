"""A queue between threads whose reader wakes up in time."""

from __future__ import annotations

import contextlib
import threading
import time
from collections import deque
from queue import Empty
from typing import Generic, TypeVar

T = TypeVar("T")


class Inbox(Generic[T]):
    """An unbounded queue that one thread reads. Any thread may put something in; so may a signal handler, whatever it interrupts.

    `queue.SimpleQueue` until Python 3.12 waits for ever, not for `timeout`, where the thread loses its core for longer than that
    inside of `get`: a short timeout on a slow machine. `queue.Queue` is not for signal handlers.
    """

    def __init__(self) -> None:
        self._items: deque[T] = deque()
        self._nothing_new = threading.Lock()
        self._nothing_new.acquire()

    def put(self, item: T) -> None:
        """Append an item and wake the reader."""
        self._items.append(item)
        if self._nothing_new.locked():
            with contextlib.suppress(RuntimeError):  # somebody else was faster
                self._nothing_new.release()

    def get(self, timeout: float | None = None) -> T:
        """Take the oldest item, waiting for one.

        Raises:
            queue.Empty: there was none for `timeout` seconds.
        """
        end = None if timeout is None else time.monotonic() + timeout
        while not self._items:
            left = threading.TIMEOUT_MAX if end is None else min(end - time.monotonic(), threading.TIMEOUT_MAX)
            if not self._nothing_new.acquire(timeout=max(0.0, left)) and not self._items:
                raise Empty
        return self._items.popleft()

    def get_nowait(self) -> T:
        """Take the oldest item. Raises queue.Empty if there is none."""
        return self.get(0.0)

    def empty(self) -> bool:
        """Whether there is nothing to take now."""
        return not self._items

    def qsize(self) -> int:
        """How many items there are now."""
        return len(self._items)
