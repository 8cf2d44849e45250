"""Lets the desktop end when its terminal is gone: Textual's output thread survives that the terminal takes no more.

The thread dies of the first write that fails, and nobody takes from its queue any more; when the queue is full the application
waits for room in it for ever, also on its way out. So a terminal window that was closed in the wrong moment left a desktop
behind, with all its programs. The same happens while the thread lives, but nobody reads what it writes (a connection that hangs).
"""

from __future__ import annotations

import contextlib
import logging
import os
import select
import threading
from queue import Empty, Full, Queue
from typing import IO

from textual.drivers._writer_thread import WriterThread

_log = logging.getLogger(__name__)

HELD = 8192
"""Bytes that may wait for `flush`."""


class Leaky:
    """A file that takes what nobody can read any more."""

    def __init__(self, file: IO[str]) -> None:
        self._file = file
        self._fd = _descriptor(file)
        self._encoding: str = getattr(file, "encoding", None) or "utf-8"
        self._held = bytearray()
        self.gone = False
        """Whether the terminal takes nothing any more."""

    def write(self, text: str) -> int:
        try:
            if self._fd is None:
                self._file.write(text.encode(self._encoding, "replace").decode(self._encoding))
            elif not self.gone:
                self._held += text.encode(self._encoding, "replace")
                if len(self._held) > HELD:
                    self.flush()
        except (OSError, ValueError):  # hung up, or the file was closed
            self.gone = True
        return len(text)

    def flush(self) -> None:
        try:
            if self.gone:
                return
            if self._fd is None:
                self._file.flush()
                return
            held, self._held = bytes(self._held), bytearray()
            _write_all(self._fd, held)
        except (OSError, ValueError):
            self.gone = True


def _descriptor(file: IO[str]) -> int | None:
    """The file's number where a terminal takes bytes."""
    if os.name != "posix":
        return None
    try:
        return file.fileno()
    except (OSError, ValueError, AttributeError):
        return None


def _write_all(fd: int, data: bytes) -> None:
    """Write, also to a terminal that another program has told not to wait (Python's own files lose text then)."""
    rest = memoryview(data)
    while rest:
        try:
            rest = rest[os.write(fd, rest) :]
        except BlockingIOError:
            select.select([], [fd], [], 1.0)


_leaving = threading.Event()
FULL_SECONDS = 0.2
"""How long a writer waits for room before it looks whether the desktop is leaving."""
LAST_SECONDS = 1.0
"""How long the desktop waits, on its way out, for a terminal to take what it still has to say."""


def install() -> None:
    """Use it for every writer thread that is started from now on."""
    if WriterThread.run is not _run:
        WriterThread.run = _run  # type: ignore[method-assign]
        WriterThread.write = _write  # type: ignore[method-assign]
        WriterThread.stop = _stop  # type: ignore[method-assign]


def let_go() -> None:
    """The desktop is leaving: from now on no picture is worth waiting for."""
    _leaving.set()


_original_run = WriterThread.run


def _run(self: WriterThread) -> None:
    file = Leaky(self._file)
    self._file = file  # type: ignore[assignment]
    while True:
        try:
            _original_run(self)
            return
        except Exception:
            _log.exception("writing to the terminal failed")
            file.gone = True


def _write(self: WriterThread, text: str) -> None:
    _put(self, text)


def _put(self: WriterThread, text: str | None) -> None:
    while True:
        try:
            self._queue.put(text, timeout=FULL_SECONDS)
            return
        except Full:
            if _leaving.is_set():
                _forget(self._queue)  # so that what gives the terminal back comes next


def _forget(queue: Queue[str | None]) -> None:
    with contextlib.suppress(Empty):
        while True:
            queue.get_nowait()


def _stop(self: WriterThread) -> None:
    _put(self, None)
    self.join(LAST_SECONDS if _leaving.is_set() else None)
