"""Writes what is sent to the terminal into a cast file, on a thread of its own: the screen never waits for the disk.

What a terminal is asked or told about its keys, mouse and modes is left out: only the picture is recorded, and no input ever.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import threading
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from queue import SimpleQueue

from day6_core.reason import reason
from day6_core.session.cores import join

MOST_WAITING = 32_000_000
"""Characters that may wait for the disk; a slower one ends the recording."""

PATIENCE = 5.0
"""Seconds that the end waits for a disk that does not answer."""

_PICTURE = re.compile(
    r"\x1b\[[0-9;:]{0,64}[ABCDEFGHJKXdfm]"  # moving, erasing, colours
    r"|\x1b\[\?25[hl]"
    r"|[^\x00-\x07\x0e-\x1f\x7f-\x9f]+"
)
"""What changes the picture, and nothing else; the last part is text with its newlines."""

_OTHER = re.compile(r"\x1b(?:[\]P_^X][^\x1b\x07]*(?:\x07|\x1b\\)|\[[0-?]*[ -/]*[@-~]|[ -/]*[0-~])")
"""A sequence that is left out whole."""


def picture_of(text: str) -> str:
    """What of a terminal's output changes the picture."""
    kept, at = [], 0
    while at < len(text):
        found = _PICTURE.match(text, at)
        if found is not None:
            kept.append(found[0])
        else:
            found = _OTHER.match(text, at)
        at = found.end() if found is not None else at + 1
    return "".join(kept)


class Recorder:
    """One recording; it begins at once. Any thread may call anything.

    `size` returns the columns and rows of the screen; `failed` is called, on the thread that writes, when the recording ends by
    itself: `fault` then says why. While `asks`, the user is being asked whether all this shall end: what is written meanwhile is
    kept back, and is part of the recording only if it goes on afterwards.

    Raises:
        OSError: the file cannot be made; FileExistsError if it exists, unless `replace`.
    """

    def __init__(
        self,
        path: Path,
        size: Callable[[], tuple[int, int]],
        *,
        replace: bool = False,
        environ: Mapping[str, str] = os.environ,
        failed: Callable[[], object] = lambda: None,
        asks: Callable[[], bool] = lambda: False,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.path = path
        self.fault = ""
        """Why it ended by itself, in the system's words."""
        self._failed = failed
        self._asks = asks
        self._size = size
        self._clock = clock
        self._began = clock()
        self._shown = size()
        if replace and path.is_file():
            path.unlink()
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
        self._file = os.open(path, flags, 0o666)
        self._queue: SimpleQueue[bytes | None] = SimpleQueue()
        self._waiting = 0
        self._lock = threading.Lock()
        self._over = False
        self._held: list[bytes] | None = None
        """What was written since the user is being asked."""
        header = {
            "version": 2,
            "width": self._shown[0],
            "height": self._shown[1],
            "timestamp": int(time.time()),
            "title": "day6-tui",
            "env": {"TERM": environ.get("TERM", "xterm-256color"), "SHELL": "day6-tui"},
        }
        self._put(header)
        self._thread = threading.Thread(target=self._work, name="day6-record", daemon=True)
        self._thread.start()
        self.write("\x1b[H\x1b[2J\x1b[?25l")

    @property
    def seconds(self) -> float:
        """How long it has been running."""
        return self._clock() - self._began

    def write(self, text: str) -> None:
        """Record what is being sent to the terminal."""
        if self._over:
            return
        self._keep_back(self._asks())
        size = self._size()
        if size != self._shown:
            self._shown = size
            self._put([round(self.seconds, 6), "r", f"{size[0]}x{size[1]}"])
        if kept := picture_of(text):
            self._put([round(self.seconds, 6), "o", kept])

    def _keep_back(self, back: bool) -> None:
        with self._lock:
            if not back and self._held and not self._over:
                self._queue.put(b"".join(self._held))
            self._held = (self._held or []) if back else None

    def stop(self) -> None:
        """End the recording and wait until it is on the disk, but not for ever."""
        with self._lock:
            self._held = None
            if not self._over:
                self._over = True
                self._queue.put(None)
        if threading.current_thread() is not self._thread:
            join(self._thread, PATIENCE)

    def _put(self, line: object) -> None:
        data = json.dumps(line, ensure_ascii=False).encode("utf-8", "replace") + b"\n"
        with self._lock:
            if self._over:
                return
            self._waiting += len(data)
            if self._waiting > MOST_WAITING:
                self._over = True
                self.fault = "the disk is too slow"
                self._queue.put(None)
                return
            if self._held is not None:
                self._held.append(data)
            else:
                self._queue.put(data)

    def _work(self) -> None:
        try:
            while (data := self._queue.get()) is not None:
                rest = memoryview(data)
                while rest:
                    rest = rest[os.write(self._file, rest) :]
                with self._lock:
                    self._waiting -= len(data)
        except OSError as error:
            self.fault = reason(error)
            with self._lock:
                self._over = True
        with contextlib.suppress(OSError):  # what could be written is written
            os.close(self._file)
        if self.fault:
            self._failed()
