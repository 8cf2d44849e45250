"""Ends this process in bounded time, whatever a signal or a key finds it doing.

Whoever runs for long says by which steps it ends and how many seconds each may take: first in order, then in a hurry. The steps
are taken on a thread of their own, because the main thread may be waiting for a terminal that takes no more output, for a
program, or for a library's destructors. Who gets through all steps and is still there is ended by force.
"""

from __future__ import annotations

import logging
import os
import signal
import sys
import threading
from collections.abc import Callable
from queue import Empty, SimpleQueue
from typing import NamedTuple

GIVE_BACK_SECONDS = 0.5
"""What giving the terminal back may take at the end by force: a terminal that is stuck cannot be written to."""

_NAMES = ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK")
_log = logging.getLogger(__name__)


class Step(NamedTuple):
    """One way to ask for the end: `act` returns at once (it is called on a foreign thread), then `seconds` are waited."""

    act: Callable[[], object]
    seconds: float | None
    """None: as long as nobody insists."""


class Ending:
    """The end of this process, which comes once: by `begin`, or by the first signal after `listen`.

    Another signal takes the next step at once; only SIGHUP does not, which the system and the shell both send when a terminal
    window is closed. `number` is the first signal, 0 if there was none.
    """

    def __init__(self, *steps: Step) -> None:
        self.number = 0
        self.begun = False
        self.give_back: Callable[[], object] | None = None
        """Called when it ends by force: what else gives the terminal back. May block; nobody waits for it for long."""
        self.nudge: Callable[[], object] | None = None
        """Called after every signal, from a foreign thread: wakes the main thread, where handlers of signals run."""
        self._steps = steps
        # Of the queues only this one may be used by a handler that interrupts another use of it.
        self._orders: SimpleQueue[bool] = SimpleQueue()
        """True: another step. False: it is over."""
        threading.Thread(target=self._watch, name="day6-ending", daemon=True).start()

    @property
    def status(self) -> int:
        """The exit status that tells of the signal, 0 if there was none."""
        return 128 + self.number if self.number else 0

    def begin(self) -> None:
        """End because the user wishes it (a key). Without effect when it has begun."""
        if not self.begun:
            self.begun = True
            self._orders.put(True)

    def listen(self, terminal: int | None = None) -> None:
        """Let SIGINT, SIGTERM and SIGHUP begin the end, from now on. On the main thread.

        So does the end of `terminal` (a descriptor), whose SIGHUP goes to the shell alone where we are not its child any more,
        and which nobody hears who was started by `nohup`.
        """
        for name in _NAMES:
            number = getattr(signal, name, None)
            if number is not None:
                signal.signal(number, self._handle)
        self._attend(terminal)

    def overhear(self) -> None:
        """The same for signals that are answered by handlers which are set already; on Windows those have to call `heard`."""
        self._attend(None)

    def heard(self, number: int) -> None:
        """A handler was called with this signal."""
        if sys.platform == "win32":
            self._signalled(number)

    def _attend(self, terminal: int | None) -> None:
        if sys.platform != "win32":
            # The system may hand a signal to any thread, and then the main one, where handlers run, sleeps on.
            reading, writing = os.pipe()
            os.set_blocking(writing, False)
            signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
            threading.Thread(target=self._read, args=(reading, terminal), name="day6-signals", daemon=True).start()

    def over(self) -> None:
        """Everything has ended: from here on a signal ends the process by itself, and silently. On the main thread."""
        for name in _NAMES:
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) == self._handle:
                signal.signal(number, signal.SIG_DFL)
        if sys.platform != "win32":
            signal.set_wakeup_fd(-1)
        self._orders.put(False)

    def _handle(self, number: int, frame: object) -> None:
        self.heard(number)

    def _read(self, reading: int, terminal: int | None) -> None:
        if sys.platform == "win32":
            return
        import select

        poll = select.poll()
        poll.register(reading, select.POLLIN)
        if terminal is not None:
            poll.register(terminal, 0)  # nothing but its end
        while True:
            for descriptor, _ in poll.poll():
                if descriptor == reading:
                    numbers = os.read(reading, 64)
                else:
                    poll.unregister(descriptor)
                    # Some systems cannot poll a terminal, and say so at once.
                    numbers = b"" if os.isatty(descriptor) else bytes([signal.SIGHUP])
                for number in numbers:
                    if number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                        self._signalled(number)
                try:
                    if self.nudge is not None:
                        self.nudge()
                except Exception:
                    _log.exception("waking the main thread failed")  # signals have to be heard all the same

    def _signalled(self, number: int) -> None:
        again = self.begun
        self.begun = True
        self.number = self.number or number
        if not again or number != getattr(signal, "SIGHUP", None):
            self._orders.put(True)

    def _watch(self) -> None:
        if not self._orders.get():
            return
        for step in self._steps:
            try:
                step.act()
            except Exception:
                _log.exception("a step of the end failed")
            try:
                if not self._orders.get(timeout=step.seconds):
                    return
            except Empty:
                continue
        self._force()

    def _force(self) -> None:
        if self.give_back is not None:
            giving = threading.Thread(target=self.give_back, name="day6-give-back", daemon=True)
            giving.start()
            giving.join(GIVE_BACK_SECONDS)
        os._exit(self.status or 1)


def leave(status: int) -> None:
    """Exit at once with `status`: everything has been closed, and Python's way out could only still hang."""
    try:
        sys.stdout.flush()
    except (OSError, ValueError):
        status = status or 1
    os._exit(status)
