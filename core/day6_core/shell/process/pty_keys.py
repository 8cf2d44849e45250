"""Keys on their way to a process: what its pty does not accept waits here, without blocking anything.

A kernel buffers about 20 kB that a program does not read, and then blocks the writer of the pty. A terminal window holds
the rest back and goes on with everything else; this does the same.
"""

from __future__ import annotations

import os
import sys
import threading
import time

from day6_core.shell.process.readiness import has_room

MOST_WAITING = 4 * 1024 * 1024
"""Bytes that may wait here; more is refused."""

LOOK_AGAIN = 0.25
"""Seconds after which the thread that waits for room checks whether it is still needed."""

UNTIL_OWNED = 0.005
"""Seconds between checks of whether the program has made the pty its terminal."""

INTERRUPT, QUIT = b"\x03", b"\x1c"


class PtyKeys:
    """Writes to the master side of a pty, which it makes one that never blocks. `close` before the pty is closed."""

    def __init__(self, master: int, slave: int) -> None:
        if sys.platform != "win32":
            os.set_blocking(master, False)
        self._master = master
        self._slave = slave
        self._lock = threading.Lock()
        self._waiting = bytearray()
        self._closed = False
        self._is_owned = False
        self._flusher: threading.Thread | None = None

    def put(self, data: bytes) -> bool:
        """Queue keys after the waiting ones, without ever blocking; return False if there is no room for them."""
        with self._lock:
            fits = len(self._waiting) + len(data) <= MOST_WAITING
            signal = max(data.rfind(INTERRUPT), data.rfind(QUIT))
            if fits:
                self._waiting += data
            elif signal >= 0:
                self._waiting += data[signal:]
            if self._closed:
                return fits  # the program has ended: what is typed now is for whoever reads next
            self._write()
            if self._waiting and signal >= 0 and self._makes_signals():
                self._overtake()
                self._write()
            if self._waiting and self._flusher is None:
                self._flusher = threading.Thread(target=self._flush, name="day6-keys", daemon=True)
                self._flusher.start()
            return fits

    def close(self) -> bytes:
        """Stop sending; return what was not sent. Called again, return what was put since."""
        with self._lock:
            self._closed = True
            waiting, self._waiting = bytes(self._waiting), bytearray()
            return waiting

    def _has_owner(self) -> bool:
        """Whether the program has made the pty its terminal: before that, a kernel has no process to signal at Ctrl-C."""
        if not self._is_owned and sys.platform != "win32":
            try:
                self._is_owned = os.tcgetpgrp(self._master) != 0
            except OSError:
                self._is_owned = True  # this system does not tell
        return self._is_owned

    def _write(self) -> None:
        if not self._has_owner():
            return
        try:
            while self._waiting:
                del self._waiting[: os.write(self._master, self._waiting[:65536])]
        except BlockingIOError:
            return
        except OSError:
            self._waiting.clear()  # the program ended at this moment

    def _makes_signals(self) -> bool:
        """Whether Ctrl-C means SIGINT to the program, rather than being a key it reads itself."""
        if sys.platform == "win32":
            return False
        import termios

        try:
            return bool(termios.tcgetattr(self._slave)[3] & termios.ISIG)
        except termios.error:
            return False

    def _overtake(self) -> None:
        """Let Ctrl-C through to a program that does not read: as in a kernel, what was typed before it is lost."""
        if sys.platform == "win32":
            return
        import termios

        at = max(self._waiting.rfind(INTERRUPT), self._waiting.rfind(QUIT))
        if at >= 0:
            termios.tcflush(self._slave, termios.TCIFLUSH)
            del self._waiting[:at]

    def _flush(self) -> None:
        """Write on as the program reads, on a thread of its own; it ends when nothing waits any more."""
        while True:
            with self._lock:
                if not self._closed:  # the descriptor may be another program's by now
                    self._write()
                if self._closed or not self._waiting:
                    self._flusher = None
                    return
                owned = self._is_owned
            if not owned:
                time.sleep(UNTIL_OWNED)
                continue
            has_room(self._master, LOOK_AGAIN)
