"""A session's thread: it waits for its sockets, and does what other threads hand to it, in that order."""

from __future__ import annotations

import heapq
import logging
import selectors
import socket
import threading
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from itertools import count

from day6_core.interrupts import unsignalled
from day6_core.link.engine_thread import run_as_engine

Task = Callable[[], None]

_log = logging.getLogger(__name__)


class Loop:
    """Any thread, and a garbage collection in the middle of anything, may call `do`: it takes no lock."""

    def __init__(self, on_end: Task) -> None:
        self._on_end = on_end
        self._selector = selectors.DefaultSelector()
        self._tasks: deque[Task] = deque()
        self._timers: list[tuple[float, int, Task]] = []
        self._numbers = count()
        self._woken, self._waking = socket.socketpair()
        for each in (self._woken, self._waking):
            each.setblocking(False)
        self._selector.register(self._woken, selectors.EVENT_READ, (self._take_waking, None))
        self._ended = False
        self._thread = threading.Thread(target=run_as_engine, args=(self._run,), name="day6-local", daemon=True)

    def start(self) -> None:
        """Begin; what was handed over before is done first."""
        with unsignalled():
            self._thread.start()

    def do(self, task: Task) -> None:
        """Have the thread do something soon."""
        self._tasks.append(task)
        with suppress(OSError):  # it is about to wake up anyway, or has ended
            self._waking.send(b"\0")

    def later(self, seconds: float, task: Task) -> None:
        """Have it do something after a time. By the thread itself only, as all below."""
        heapq.heappush(self._timers, (time.monotonic() + seconds, next(self._numbers), task))

    def watch(self, what: socket.socket, on_readable: Task, on_writable: Task | None = None) -> None:
        """Call these when a socket can be read from or, with `on_writable`, written to; replaces what was watched for."""
        events = selectors.EVENT_READ | (selectors.EVENT_WRITE if on_writable is not None else 0)
        change = self._selector.modify if what in self._selector.get_map() else self._selector.register
        change(what, events, (on_readable, on_writable))

    def forget(self, what: socket.socket) -> None:
        """Watch a socket no more; before it is closed."""
        with suppress(KeyError):
            self._selector.unregister(what)

    def end(self) -> None:
        """Let the turn be the last."""
        self._ended = True

    @property
    def is_current(self) -> bool:
        """Whether the caller is this thread."""
        return threading.get_ident() == self._thread.ident

    def join(self, timeout: float) -> None:
        """Wait for the end, unless this is the thread itself."""
        if self._thread.is_alive() and not self.is_current:
            self._thread.join(timeout)

    def abandon(self) -> None:
        """In a forked child, which has no copy of the thread: close its copies of what the thread waits with."""
        self._tasks.clear()
        for each in (self._selector, self._woken, self._waking):
            each.close()

    def _run(self) -> None:
        try:
            while not self._ended:
                self._turn()
        finally:
            self._on_end()
            self.abandon()

    def _turn(self) -> None:
        left = self._timers[0][0] - time.monotonic() if self._timers else None
        ready = self._selector.select(0 if self._tasks else left)
        # First what this process did before it got what the others did after that.
        for _ in range(len(self._tasks)):
            _safely(self._tasks.popleft())
        for key, events in ready:
            on_readable, on_writable = key.data
            if key.fd not in self._selector.get_map():
                continue  # it has been closed meanwhile
            if events & selectors.EVENT_WRITE and on_writable is not None:
                _safely(on_writable)
            if events & selectors.EVENT_READ:
                _safely(on_readable)
        while self._timers and self._timers[0][0] <= time.monotonic():
            _safely(heapq.heappop(self._timers)[2])

    def _take_waking(self) -> None:
        with suppress(BlockingIOError):
            self._woken.recv(4096)


def _safely(task: Task) -> None:
    try:
        task()
    except Exception:
        _log.exception("the thread of the local link goes on after this")  # a fault of ours; everything else is caught
