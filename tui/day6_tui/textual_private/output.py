"""Lets the desktop end when its terminal is gone: keeps Textual's output thread alive when writing fails.

Textual's thread dies at the first failed write, and its queue is no longer emptied; once the queue is full the application
waits for ever, even while exiting. So closing a terminal window at the wrong moment would leave a desktop behind, with all
its programs. The same would happen if the thread lives but nothing reads what it writes (a hanging connection).

While the terminal takes what it is sent, the thread is not needed at all: waking it costs more than writing. Then a frame is
written where it was made, whole, without blocking; what the terminal does not take at once goes to the thread.
"""

from __future__ import annotations

import contextlib
import logging
import os
import select
import sys
import threading
from queue import Empty, Full, Queue
from typing import IO
from weakref import WeakKeyDictionary

from textual._ansi_sequences import SYNC_END, SYNC_START
from textual.drivers._writer_thread import WriterThread

from day6_core.session.cores import join
from day6_core.virtual import surroundings
from day6_core.virtual.surroundings import in_real_time

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
        if self._fd is not None and surroundings.pace is not None:  # no thread may wait in earnest there
            self._fd = _second_descriptor(self._fd) or self._fd
        self._encoding: str = getattr(file, "encoding", None) or "utf-8"
        self._held = bytearray()
        self.taken = 0
        """Bytes that the terminal has taken."""
        self.gone = False
        """Whether the terminal no longer accepts output."""

    @property
    def number(self) -> int | None:
        """The descriptor of a terminal that takes bytes."""
        return self._fd

    @property
    def encoding(self) -> str:
        """The encoding of what is written."""
        return self._encoding

    def write(self, text: str | bytes) -> int:
        try:
            data = text if isinstance(text, bytes) else text.encode(self._encoding, "replace")
            if self._fd is None:
                self._file.write(data.decode(self._encoding))
            elif not self.gone:
                self._held += data
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


class Shortcut:
    """Writes to the terminal on the spot while nothing waits to be written and the terminal takes it."""

    def __init__(self, file: Leaky) -> None:
        self._file = file
        self._fd = None if file.number is None else _second_descriptor(file.number)
        self._lock = threading.Lock()
        self._waiting = 0
        """Texts that the thread has not written yet."""
        self._frame: list[str] | None = None
        """The pieces of a frame that is not complete."""

    def take(self, text: str) -> str | bytes | None:
        """Write a text, or keep it until its frame is complete; return what the thread has to write."""
        if self._frame is not None:
            self._frame.append(text)
            if text != SYNC_END:
                return None
            text, self._frame = "".join(self._frame), None
        elif text == SYNC_START:
            self._frame = [text]
            return None
        return self._written(text)

    def kept(self) -> str:
        """What was kept of a frame that will not be completed."""
        pieces, self._frame = self._frame or [], None
        return "".join(pieces)

    def _written(self, text: str) -> str | bytes | None:
        with self._lock:
            if self._waiting or self._fd is None or self._file.gone:
                self._waiting += 1
                return text
            data = text.encode(self._file.encoding, "replace")
            try:
                written = os.write(self._fd, data)
            except BlockingIOError:
                written = 0
            except OSError:
                self._file.gone = True
                return None
            self._file.taken += written
            if written == len(data):
                return None
            self._waiting += 1
            return data[written:]

    def done(self, texts: int) -> None:
        """The thread has written so many of them."""
        with self._lock:
            self._waiting -= texts

    def close(self) -> None:
        """Let the thread write everything from now on."""
        with self._lock:
            fd, self._fd = self._fd, None
        if fd is not None:
            os.close(fd)


def _second_descriptor(number: int) -> int | None:
    """Open the terminal once more, not blocking: the first descriptor's mode is shared with other programs."""
    if sys.platform == "win32":
        return None
    try:
        fd = os.open(os.ttyname(number), os.O_WRONLY | os.O_NOCTTY | os.O_NONBLOCK)
    except OSError:  # no terminal, or one of another file system
        return None
    if os.fstat(fd).st_rdev != os.fstat(number).st_rdev:
        os.close(fd)
        return None
    return fd


_shortcuts: WeakKeyDictionary[WriterThread, Shortcut] = WeakKeyDictionary()
_leaving = threading.Event()
_last_words: list[str] = []
"""What was written since then: it gives the terminal back, and is never thrown away."""
FULL_SECONDS = 0.2
"""Seconds a writer waits for room before it checks whether the desktop is exiting."""
LAST_SECONDS = 1.0
"""Seconds in which the terminal must take something of the exiting desktop's last output, or it is not waited for."""


def install() -> None:
    """Use this for every writer thread made from now on."""
    if WriterThread.run is not _run:
        WriterThread.__init__ = _init  # type: ignore[method-assign]
        WriterThread.run = _run  # type: ignore[method-assign]
        WriterThread.write = _write  # type: ignore[method-assign]
        WriterThread.stop = _stop  # type: ignore[method-assign]


def let_go() -> None:
    """Stop waiting for the terminal: the desktop is exiting, and no picture matters any more."""
    _leaving.set()


_original_init = WriterThread.__init__


def _init(self: WriterThread, file: IO[str]) -> None:
    leaky = Leaky(file)
    _original_init(self, leaky)  # type: ignore[arg-type]
    _shortcuts[self] = Shortcut(leaky)


def _run(self: WriterThread) -> None:
    in_real_time()
    file, shortcut = self._file, _shortcuts[self]
    assert isinstance(file, Leaky)
    written = 0
    while (text := self._queue.get()) is not None:
        try:
            file.write(text)
            written += 1
            if self._queue.empty():
                file.flush()
                shortcut.done(written)
                written = 0
        except Exception:
            _log.exception("writing to the terminal failed")
            file.gone = True
    file.flush()


def _write(self: WriterThread, text: str) -> None:
    shortcut = _shortcuts[self]
    if _leaving.is_set():
        shortcut.close()
        _put(self, shortcut.kept() + text)
    elif (rest := shortcut.take(text)) is not None:
        _put(self, rest)


def _put(self: WriterThread, text: str | bytes | None) -> None:
    if isinstance(text, str) and _leaving.is_set():
        _last_words.append(text)
    while True:
        try:
            self._queue.put(text, timeout=FULL_SECONDS)  # type: ignore[arg-type]
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
    shortcut = _shortcuts[self]
    shortcut.close()
    if kept := shortcut.kept():
        _put(self, kept)
    _put(self, None)
    if not _leaving.is_set():
        self.join()
    taken = -1
    while self.is_alive() and taken != (taken := getattr(self._file, "taken", 0)):
        join(self, LAST_SECONDS)
