"""Lets the desktop end when its terminal is gone: keeps Textual's output thread alive when writing fails.

Textual's thread dies at the first failed write, and its queue is no longer emptied; once the queue is full the application
waits for ever, even while exiting. So closing a terminal window at the wrong moment would leave a desktop behind, with all
its programs. The same would happen if the thread lives but nothing reads what it writes (a hanging connection).
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
PIECE = 1024
"""Bytes that are written at a time."""


class Leaky:
    """A file that discards writes once the terminal is gone."""

    def __init__(self, file: IO[str]) -> None:
        self._file = file
        self._fd = _descriptor(file)
        self._encoding: str = getattr(file, "encoding", None) or "utf-8"
        self._held = bytearray()
        self.taken = 0
        """Bytes that the terminal has taken."""
        self.gone = False
        """Whether the terminal no longer accepts output."""

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
            for start in range(0, len(held), PIECE):
                piece = held[start : start + PIECE]
                _write_all(self._fd, piece)
                self.taken += len(piece)
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
    """Write, even to a terminal that another program made non-blocking (Python's own files lose text then)."""
    rest = memoryview(data)
    while rest:
        try:
            rest = rest[os.write(fd, rest) :]
        except BlockingIOError:
            select.select([], [fd], [], 1.0)


_leaving = threading.Event()
_last_words: list[str] = []
"""What was written since then: it gives the terminal back, and is never thrown away."""
FULL_SECONDS = 0.2
"""Seconds a writer waits for room before it checks whether the desktop is exiting."""
LAST_SECONDS = 1.0
"""Seconds in which the terminal must take something of the exiting desktop's last output, or it is not waited for."""


def install() -> None:
    """Use this for every writer thread started from now on."""
    if WriterThread.run is not _run:
        WriterThread.run = _run  # type: ignore[method-assign]
        WriterThread.write = _write  # type: ignore[method-assign]
        WriterThread.stop = _stop  # type: ignore[method-assign]


def let_go() -> None:
    """Stop waiting for the terminal: the desktop is exiting, and no picture matters any more."""
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
    if text is not None and _leaving.is_set():
        _last_words.append(text)
    while True:
        try:
            self._queue.put(text, timeout=FULL_SECONDS)
            return
        except Full:
            if _leaving.is_set():
                _forget(self._queue)  # so that what gives the terminal back comes next
                self._queue.put("".join(_last_words))  # the beginning may come twice, which is harmless
                if text is not None:
                    return


def _forget(queue: Queue[str | None]) -> None:
    with contextlib.suppress(Empty):
        while True:
            queue.get_nowait()


def _stop(self: WriterThread) -> None:
    _put(self, None)
    if not _leaving.is_set():
        self.join()
    taken = -1
    while self.is_alive() and taken != (taken := getattr(self._file, "taken", 0)):
        self.join(LAST_SECONDS)
