"""Lets the desktop end when its terminal is gone: Textual's output thread survives that the terminal takes no more.

The thread dies of the first write that fails, and nobody takes from its queue any more; when the queue is full the application
waits for room in it for ever, also on its way out. So a terminal window that was closed in the wrong moment left a desktop
behind, with all its programs. The same happens while the thread lives, but nobody reads what it writes (a connection that hangs).
"""

from __future__ import annotations

import contextlib
import threading
from queue import Empty, Full, Queue
from typing import IO, Any

from textual.drivers._writer_thread import WriterThread


class Leaky:
    """A file that takes what nobody can read any more."""

    def __init__(self, file: IO[str]) -> None:
        self._file = file
        self._gone = False

    def write(self, text: str) -> int:
        self._try(self._file.write, text)
        return len(text)

    def flush(self) -> None:
        self._try(self._file.flush)

    def _try(self, function: Any, *arguments: str) -> None:
        if not self._gone:
            try:
                function(*arguments)
            except (OSError, ValueError):  # hung up, or the file was closed
                self._gone = True


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
    self._file = Leaky(self._file)  # type: ignore[assignment]
    _original_run(self)


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
