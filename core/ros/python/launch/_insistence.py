"""Gets Ctrl-C and SIGTERM through to a launch whose thread is in the code of a launch file.

The launch's own waiting hears of a signal at once. A launch file that sleeps, or never ends, is interrupted as any Python
program: the real launch leaves Python's own handler in place beside its own, which raises KeyboardInterrupt there.
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
"""Seconds that a signal waits for what is being visited before it is raised in the middle of it."""
LAST_PATIENCE = 1.5
"""Seconds after which SIGTERM ends a process whose launch file did not even let that pass."""


class Insistence:
    """Watches over the signals of one launch. The handlers call `told` and `check`, the launch `heard`.

    `at_last` is called, on a thread of its own, before SIGTERM ends the process by force.
    """

    def __init__(self, at_last: Callable[[], object]) -> None:
        self.visiting = False
        """Kept by the launch: its thread is in a handler, an action or a substitution, which may be the user's."""
        self._at_last = at_last
        self._told = self._heard = 0
        self._overdue: BaseException | None = None
        # Of the queues only this one may be used by a handler that interrupts another use of it.
        self._signals: SimpleQueue[tuple[int, BaseException] | None] = SimpleQueue()
        self._main = threading.get_ident()
        threading.Thread(target=self._watch, name="launch-signals", daemon=True).start()

    def told(self, number: int, error: BaseException) -> None:
        """A signal came; `error` is what to raise if nobody hears of it."""
        self._told += 1
        self._signals.put((number, error))

    def heard(self) -> None:
        """The launch has taken notice of one signal."""
        self._heard += 1

    def check(self) -> bool:
        """Say whether this call of the handler is the watcher's; raises what is overdue, if there is code to be interrupted."""
        error, self._overdue = self._overdue, None
        if error is not None and self.visiting:
            raise error
        return error is not None

    def close(self) -> None:
        self._signals.put(None)

    def _watch(self) -> None:
        while (signalled := self._signals.get()) is not None:
            number, error = signalled
            count = self._told
            time.sleep(PATIENCE)
            if self._heard >= count or not self.visiting:
                continue
            self._overdue = error
            if sys.platform != "win32":
                signal.pthread_kill(self._main, number)  # also out of a system call
            else:
                signal.raise_signal(number)
            if number == signal.SIGINT:
                continue
            end = time.monotonic() + LAST_PATIENCE
            while self._heard < count and time.monotonic() < end:
                time.sleep(0.05)
            if self._heard < count:
                self._at_last()
                os._exit(128 + number)
