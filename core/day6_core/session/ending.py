"""Ends this process in bounded time, whatever a signal or a key finds it doing.

A long-running program passes the steps by which it ends and how many seconds each may take: first in order, then in a hurry.
The steps run on a thread of their own, because the main thread may be waiting for a terminal that takes no more output, for a
program, or for a library's destructors. A process that still runs after the last step is ended by force.
"""

from __future__ import annotations

import contextlib
import logging
import os
import signal
import sys
import threading
from collections.abc import Callable
from queue import Empty
from typing import NamedTuple

from day6_core.inbox import Inbox
from day6_core.session.cores import Allowance, join
from day6_core.virtual import surroundings
from day6_core.virtual.surroundings import in_real_time

RESTORE_SECONDS = 0.5
"""Seconds that restoring the terminal may take at a forced end: a terminal that is stuck cannot be written to."""

_NAMES = ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK")
_log = logging.getLogger(__name__)


class EndingStep(NamedTuple):
    """One way to request the end: `act` returns at once (it is called on another thread), then up to `seconds` are waited.

    Those in which the main thread waits for a core do not count.
    """

    act: Callable[[], object]
    seconds: float | None
    """None: until the next signal or key."""


class Ending:
    """The end of this process, which comes once: by `begin`, or by the first signal after `handle_signals`.

    Another signal starts the next step at once, except SIGHUP, which both the system and the shell send when a terminal window
    is closed. `number` is the first signal, 0 if there was none.
    """

    def __init__(self, *steps: EndingStep) -> None:
        self.number = 0
        self.begun = False
        self.restore_terminal: Callable[[], object] | None = None
        """Called at a forced end to restore the terminal. May block: it gets RESTORE_SECONDS."""
        self.wake_main_thread: Callable[[], object] | None = None
        """Called after every signal, from another thread: wakes the main thread, where signal handlers run."""
        self._steps = steps
        self._orders: Inbox[bool] = Inbox()
        """True: take the next step. False: everything has ended."""
        threading.Thread(target=self._watch, name="day6-ending", daemon=True).start()

    @property
    def status(self) -> int:
        """The exit status for the signal (128 + its number), 0 if there was none."""
        return 128 + self.number if self.number else 0

    def begin(self) -> None:
        """End at the user's wish (a key). Does nothing once the end has begun."""
        if not self.begun:
            self.begun = True
            self._orders.put(True)

    def handle_signals(self, terminal: int | None = None) -> None:
        """Let SIGINT, SIGTERM and SIGHUP begin the end, from now on. Call it on the main thread.

        So does a hang-up of `terminal` (a descriptor): its SIGHUP goes to the shell alone where we are no longer its child,
        and is ignored in a program that was started by `nohup`.
        """
        for name in _NAMES:
            number = getattr(signal, name, None)
            if number is not None:
                signal.signal(number, self._handle)
        self._attend(terminal)

    def watch_signals(self) -> None:
        """Attend to signals whose handlers are already installed; on Windows they have to call `signal_received`."""
        self._attend(None)

    def signal_received(self, number: int) -> None:
        """To be called by signal handlers: on Windows they are the only ones that see the signal."""
        if sys.platform == "win32":
            self._signalled(number)

    def _attend(self, terminal: int | None) -> None:
        if sys.platform != "win32":
            # The system may deliver a signal to any thread; the main one, where handlers run, then sleeps on.
            reading, writing = os.pipe()
            os.set_blocking(writing, False)
            signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
            threading.Thread(target=self._read, args=(reading, terminal), name="day6-signals", daemon=True).start()

    def over(self) -> None:
        """Everything has ended: from here on a signal ends the process by default, silently. Call it on the main thread."""
        for name in _NAMES:
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) == self._handle:
                signal.signal(number, signal.SIG_DFL)
        if sys.platform != "win32":
            signal.set_wakeup_fd(-1)
        self._orders.put(False)

    def _handle(self, number: int, frame: object) -> None:
        self.signal_received(number)

    def _read(self, reading: int, terminal: int | None) -> None:
        in_real_time()
        if sys.platform == "win32":
            return
        import select

        poll = select.poll()
        poll.register(reading, select.POLLIN)
        if terminal is not None:
            poll.register(terminal, 0)  # only its hang-up
        while True:
            for descriptor, _ in poll.poll():
                if descriptor == reading:
                    numbers = os.read(reading, 64)
                else:
                    poll.unregister(descriptor)
                    # Some systems cannot poll a terminal and report that at once.
                    numbers = b"" if os.isatty(descriptor) else bytes([signal.SIGHUP])
                for number in numbers:
                    if number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                        self._signalled(number)
                try:
                    if self.wake_main_thread is not None:
                        self.wake_main_thread()
                except Exception:
                    _log.exception("waking the main thread failed")  # signals must be handled all the same

    def _signalled(self, number: int) -> None:
        again = self.begun
        self.begun = True
        self.number = self.number or number
        if not again or number != getattr(signal, "SIGHUP", None):
            self._orders.put(True)

    def _watch(self) -> None:
        in_real_time()
        if not self._orders.get():
            return
        for step in self._steps:
            try:
                step.act()
            except Exception:
                _log.exception("a step of the end failed")
            if self._within(step.seconds) is False:
                return
        self._force()

    def _within(self, seconds: float | None) -> bool | None:
        """Return the next order, or None if none comes within the seconds of a step."""
        if seconds is None:
            return self._orders.get()
        allowance = Allowance(seconds, threading.main_thread())
        while True:
            with contextlib.suppress(Empty):
                return self._orders.get(timeout=max(0.0, allowance.left()))
            if allowance.left() <= 0:
                return None

    def _force(self) -> None:
        if self.restore_terminal is not None:
            restoring = threading.Thread(target=self.restore_terminal, name="day6-restore-terminal", daemon=True)
            restoring.start()
            join(restoring, RESTORE_SECONDS)
        surroundings.leave()
        os._exit(self.status or 1)


def leave(status: int) -> None:
    """Exit at once with `status`: everything has been closed, and Python's own shutdown could only hang."""
    try:
        sys.stdout.flush()
    except (OSError, ValueError):
        status = status or 1
    surroundings.leave()
    os._exit(status)
