"""Gets Ctrl-C and SIGTERM through to a launch whose thread is running the code of a launch file.

While the launch itself waits, a signal is handled at once. A launch file that sleeps, or never ends, is interrupted like any
Python program: the real launch keeps Python's own handler beside its own, which raises KeyboardInterrupt there.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Callable
from queue import SimpleQueue

PATIENCE = 0.3
"""Seconds that a signal waits for the current visit before it is raised in the middle of it."""
LAST_PATIENCE = 1.5
"""Seconds after which SIGTERM ends a process whose launch file swallowed even the exception."""


class SignalWatchdog:
    """Makes sure that a launch handles its signals. The handlers call `received` and `check`, the launch `mark_handled`.

    `before_exit` is called, on the watchdog's thread, before SIGTERM ends the process by force.
    """

    def __init__(self, before_exit: Callable[[], object]) -> None:
        self.visiting = False
        """Set by the launch while its thread runs a handler, an action or a substitution, which may be the user's."""
        self._before_exit = before_exit
        self._received = self._handled = 0
        self._overdue: BaseException | None = None
        # The only queue that is reentrant: a signal handler may interrupt another use of it.
        self._signals: SimpleQueue[tuple[int, BaseException] | None] = SimpleQueue()
        self._main = threading.get_ident()
        threading.Thread(target=self._watch, name="launch-signals", daemon=True).start()

    def received(self, number: int, error: BaseException) -> None:
        """Note a signal; `error` is raised if the launch doesn't handle it."""
        self._received += 1
        self._signals.put((number, error))

    def mark_handled(self) -> None:
        """Note that the launch has handled one signal."""
        self._handled += 1

    def check(self) -> bool:
        """Return whether the watchdog sent this signal; raises the overdue error if there is code to interrupt."""
        error, self._overdue = self._overdue, None
        if error is not None and self.visiting:
            raise error
        return error is not None

    def close(self) -> None:
        """End the watchdog's thread."""
        self._signals.put(None)

    def _watch(self) -> None:
        while (signalled := self._signals.get()) is not None:
            number, error = signalled
            count = self._received
            time.sleep(PATIENCE)
            if self._handled >= count or not self.visiting:
                continue
            self._overdue = error
            if sys.platform != "win32":
                signal.pthread_kill(self._main, number)  # also out of a system call
            else:
                signal.raise_signal(number)
            if number == signal.SIGINT:
                continue
            end = time.monotonic() + LAST_PATIENCE
            while self._handled < count and time.monotonic() < end:
                time.sleep(0.05)
            if self._handled < count:
                self._before_exit()
                os._exit(128 + number)
