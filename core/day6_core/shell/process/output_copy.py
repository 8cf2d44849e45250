"""The thread that takes what a process writes, and how it is read from pipes and ptys."""

from __future__ import annotations

import codecs
import io
import logging
import os
import sys
import threading
from collections.abc import Callable, Iterator
from typing import IO

from day6_core.session.streams import OutputStream
from day6_core.shell.process.readiness import has_output

READ_SIZE = 65536

_log = logging.getLogger(__name__)


class OutputCopy(threading.Thread):
    """Copies a process's output to a stream, and tells `seen`, as it comes, until its end; waits while the stream is full."""

    def __init__(
        self,
        source: int | IO[bytes],
        target: OutputStream,
        seen: Callable[[str], None] | None,
        read: Callable[[int], bytes],
    ) -> None:
        super().__init__(name="day6-output", daemon=True)
        self._source, self._target, self._seen, self._read = source, target, seen, read
        self._fd = source if isinstance(source, int) else source.fileno()
        self._waits = False
        """Whether it looks for output and has taken all that it has seen."""

    def run(self) -> None:
        """Copy until the end."""
        target = self._target
        decoder: codecs.IncrementalDecoder | io.IncrementalNewlineDecoder
        decoder = codecs.getincrementaldecoder("utf-8")("replace" if target.isatty() else "surrogateescape")
        if sys.platform == "win32":
            decoder = io.IncrementalNewlineDecoder(decoder, translate=True)
        pieces = self._pieces()
        try:
            for data in pieces:
                text = decoder.decode(data, final=not data)
                if text:
                    target.write(text)
                    if self._seen is not None:
                        self._seen(text)
                target.wait_for_room()
        except BrokenPipeError:
            return  # the reader is gone; closing our end tells the process, as in any pipeline
        except Exception:
            _log.exception("output of a process could not be taken")
            for _ in pieces:
                pass  # read to the end: the process would wait for a reader for ever
        finally:
            if not isinstance(self._source, int):
                self._source.close()

    def _pieces(self) -> Iterator[bytes]:
        """Yield what is read as it comes, and b'' at the end."""
        data = b"some"
        while data:
            try:
                self._wait()
                data = self._read(self._fd)
            except BlockingIOError:
                continue  # what was there has been discarded
            except OSError:
                data = b""  # Linux: the last process left the pty
            yield data

    def _wait(self) -> None:
        self._waits = True
        has_output(self._fd, None)
        self._waits = False

    def is_behind(self) -> bool:
        """Whether something that has been written is not in the stream yet."""
        if sys.platform == "win32" or not self.is_alive():
            return False
        # In this order: it stops waiting before it takes what is there.
        return not self._waits or has_output(self._fd, 0.0) or not self._waits


def read_at_once(fd: int) -> bytes:
    """Return what a pipe has, after waiting for something; b'' at its end."""
    return os.read(fd, READ_SIZE)


def read_waiting(fd: int) -> bytes:
    """Return all that waits in a pty whose side here never blocks (see `PtyKeys`); b'' at its end.

    A pty hands out 4 kB at a time, and what follows a read costs more than the read. Raises BlockingIOError if there is nothing.
    """
    parts: list[bytes] = []
    size = 0
    while size < READ_SIZE:
        try:
            data = os.read(fd, READ_SIZE)
        except OSError:
            if parts:
                break  # nothing more; the end is there the next time, too
            raise
        if not data:
            break
        parts.append(data)
        size += len(data)
    return b"".join(parts)
