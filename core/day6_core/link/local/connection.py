"""A connection to another process: who is there, what it has declared, and what waits to be sent to it.

Any thread may send. It writes into the socket itself while nothing waits, and never blocks in there; what the socket doesn't take
is sent by the session's thread. Messages for a process that doesn't keep up are dropped, everything else waits.
"""

from __future__ import annotations

import socket
import threading
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING

from day6_core.interrupts import DEFERRED
from day6_core.link.local.frames import FrameReader

if TYPE_CHECKING:
    from day6_core.link.local.handshake import Handshake

MOST_WAITING = 2 * 1024 * 1024
"""Bytes that wait for one process; more messages are dropped, or their publishers wait (see `wait_for_room`)."""
MOST_WAITING_IN_ALL = 256 * 1024 * 1024
"""Bytes, with the announcements, requests and responses, which are never dropped: with more the connection is closed."""
STALLED_SECONDS = 0.5
"""A process that has taken nothing for that long has stopped, or is stuck: nobody waits for it."""
_TOGETHER = 1 << 16
"""Bytes of small frames that are written at once."""


class Connection:
    """`on_backlog` is called, by any thread, when the session's thread has to send the rest or close the connection."""

    def __init__(
        self, connected: socket.socket, handshake: Handshake, on_backlog: Callable[[Connection], None]
    ) -> None:
        connected.setblocking(False)
        self.socket = connected
        self.handshake = handshake
        self.reader = FrameReader()
        self.closed = False
        self.broken = False
        """It can't be written to: to be closed."""
        self.waiting = 0
        """Bytes."""
        self._on_backlog = on_backlog
        self._lock = threading.RLock()  # reentrant: a garbage collection may send something in the middle of it
        self._frames: deque[bytes] = deque()
        self._unsent = memoryview(b"")
        self._sending = False
        self._last_taken = time.monotonic()

    def send(self, frame: bytes) -> bool:
        """Send a frame that may not be lost; return whether the connection still stands."""
        if self.waiting > MOST_WAITING_IN_ALL:
            self._break()
        return self._put(frame)

    def offer(self, frame: bytes, *, patiently: bool = False) -> None:
        """Send a message, unless too much is waiting."""
        if (patiently and self.wait_for_room()) or not self.waiting or self.waiting + len(frame) <= MOST_WAITING:
            self._put(frame)

    def wait_for_room(self) -> bool:
        """Wait until a message would not be dropped; False without room, for a process that takes nothing."""
        while self.waiting > MOST_WAITING and not self.closed and not self.broken:
            if self.is_stalled:
                return False
            time.sleep(0.001)
        return True

    @property
    def is_stalled(self) -> bool:
        """Whether the other side takes nothing of what waits."""
        return self.waiting > 0 and time.monotonic() - self._last_taken > STALLED_SECONDS

    def flush(self) -> bool:
        """Send what waits, as much as the socket takes; return whether that was all."""
        with DEFERRED, self._lock:
            self._flush()
        return not self.waiting

    def say_goodbye(self) -> None:
        """Send nothing any more; the other side closes when it has read everything."""
        with suppress(OSError):
            self.socket.shutdown(socket.SHUT_WR)

    def close(self) -> None:
        """Close the socket; nothing is sent any more. By the session's thread."""
        with DEFERRED, self._lock:
            self.closed = True
            self._frames.clear()
            self._unsent, self.waiting = memoryview(b""), 0
            self.socket.close()

    def _put(self, frame: bytes) -> bool:
        # No Ctrl-C between writing and noting how much was written.
        with DEFERRED, self._lock:
            if self.closed or self.broken:
                return False
            self._frames.append(frame)
            was_waiting, self.waiting = self.waiting, self.waiting + len(frame)
            self._flush()
            if self.waiting and not was_waiting and not self.broken:
                self._on_backlog(self)
        return True

    def _flush(self) -> None:
        if self._sending or self.closed or self.broken:
            return
        self._sending = True
        try:
            while self._unsent or self._frames:
                if not self._unsent:
                    self._unsent = self._next()
                sent = self.socket.send(self._unsent)
                self._unsent = self._unsent[sent:]
                self.waiting -= sent
                self._last_taken = time.monotonic()
        except (BlockingIOError, InterruptedError):
            pass
        except OSError:
            self._break()
        finally:
            self._sending = False

    def _next(self) -> memoryview:
        """Return the next frame, or several small ones."""
        first = self._frames.popleft()
        if not self._frames or len(first) >= _TOGETHER:
            return memoryview(first)
        together, size = [first], len(first)
        while self._frames and size + len(self._frames[0]) <= _TOGETHER:
            together.append(self._frames.popleft())
            size += len(together[-1])
        return memoryview(b"".join(together))

    def _break(self) -> None:
        self.broken = True
        self._on_backlog(self)
