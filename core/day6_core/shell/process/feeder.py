"""Writes to the pipe of a process's standard input, on a thread of its own, because a full pipe blocks its writer."""

from __future__ import annotations

import contextlib
import os
import threading
from queue import SimpleQueue
from typing import IO

from day6_core.session.task import Signal

FULL = 256 * 1024
"""Bytes that may wait for the process; beyond that the program that writes them pauses."""


class Feeder:
    """Accepts data from the scheduler's thread, which never waits for the process."""

    def __init__(self, pipe: IO[bytes]) -> None:
        self._pipe = pipe
        self._queue: SimpleQueue[bytes] = SimpleQueue()
        self._put = 0
        self._written = 0
        self._lock = threading.Lock()
        self.broken = False
        """Whether the process has closed its end, or has ended."""
        self.has_room = Signal()
        """Set when something was written, or will never be."""
        threading.Thread(target=self._write, name="day6-feed", daemon=True).start()

    @property
    def is_full(self) -> bool:
        """Whether the writer should wait for room."""
        return not self.broken and self._put - self._written > FULL

    def put(self, data: bytes) -> bool:
        """Write `data` soon; b'' closes the pipe. Return False if nobody will read it."""
        with self._lock:
            if self.broken:
                return False
            self._put += len(data)
            self._queue.put(data)
            return True

    def take_back(self, reader: int) -> bytes:
        """Take nothing more; return what the process that has ended did not read. `reader` is our own end of its pipe."""
        with self._lock:
            self.broken = True
            self._queue.put(b"")
        parts = []
        while part := os.read(reader, FULL):
            parts.append(part)
        return b"".join(parts)

    def _write(self) -> None:
        try:
            while data := self._queue.get():
                self._pipe.write(data)
                if self._queue.empty():
                    self._pipe.flush()
                self._written += len(data)
                if self._put - self._written <= FULL // 2:
                    self.has_room.set()
        except (OSError, ValueError):
            self.broken = True  # it ended without reading the rest
        finally:
            with contextlib.suppress(OSError, ValueError):
                self._pipe.close()
            self.broken = True
            self.has_room.set()
