"""Starts a program in its session and says what its end means, in the numbers and words a shell knows."""

from __future__ import annotations

import contextlib
import logging

from day6_tui.core.graph.domain import DomainError
from day6_tui.core.session.session import KilledBySignal, Main, Session
from day6_tui.core.session.streams import WriteError
from day6_tui.core.session.task import Signal, Task, TaskCancelled, wait_for

_log = logging.getLogger(__name__)

SIGINT = 2
SIGKILL = 9  # signal.SIGKILL does not exist on Windows
SIGPIPE = 13


class Program:
    """A running cooperative program. `status` is None until it has ended; `killed_by` is the signal that ended it, or 0."""

    def __init__(self, session: Session, main: Main) -> None:
        self.session = session
        self.status: int | None = None
        self.killed_by = 0
        self.stopped = False
        self.done = Signal()
        self._watchers: list[Signal] = []
        self._task: Task = session.scheduler.spawn(self._run(main), session.name)
        session.task = self._task

    @property
    def pid(self) -> int:
        return self.session.pid

    async def wait(self) -> int:
        """Wait for the end; return the exit status (128 + signal for a program that a signal ended)."""
        await wait_for(self.done)
        assert self.status is not None
        return self.status

    def send(self, number: int) -> None:
        """Deliver a signal by its number; those that a program may ignore by default are ignored."""
        action = _SIGNALS.get(number)
        if action is not None:
            action(self)
        elif number in _ENDING:
            self._task.throw(KilledBySignal(number))

    def interrupt(self) -> None:
        self.session.interrupt()

    def terminate(self) -> None:
        self.session.terminate()

    def kill(self) -> None:
        self._task.cancel()

    def stop(self) -> None:
        self.stopped = True
        self.session.stop()
        self._tell()

    def resume(self) -> None:
        self.stopped = False
        self.session.resume()

    async def _run(self, main: Main) -> None:
        try:
            self.status = await _status_of(self.session, main)
            if self._task.undelivered is not None:
                raise self._task.undelivered  # a signal that came before it was over, and found no wait to be raised in
        except KeyboardInterrupt:
            self._killed(SIGINT)
        except KilledBySignal as end:
            self._killed(end.number)
        except TaskCancelled:
            self._killed(SIGKILL)
        except BrokenPipeError:
            # Nobody reads what it says any more: a real program gets SIGPIPE and ends without a word.
            self._killed(SIGPIPE)
        finally:
            if self.status is None:
                self.status = 1
            self.session.close()
            self.done.set()
            self._tell()

    def watch(self, signal: Signal) -> None:
        """Set `signal` whenever the program ended or was stopped (at once, if it has ended)."""
        self._watchers.append(signal)
        if self.done.is_set():
            signal.set()

    def _tell(self) -> None:
        for signal in self._watchers:
            signal.set()

    def _killed(self, number: int) -> None:
        self.killed_by = number
        self.status = 128 + number


async def _status_of(session: Session, main: Main) -> int:
    """The status that `main` ends with; what could not be written of its output is part of that."""
    try:
        status = await _end_of(session, main)
        session.stdout.flush()
    except WriteError as error:
        status = session.on_write_error(session, error)
    with contextlib.suppress(WriteError):  # nobody is left to be told
        session.stderr.flush()
    return status


async def _end_of(session: Session, main: Main) -> int:
    try:
        return (await main(session)) or 0
    except SystemExit as end:
        if end.code is None or isinstance(end.code, int):
            return end.code or 0
        session.print_error(end.code)
        return 1
    except (BrokenPipeError, WriteError):
        raise
    except DomainError as error:
        session.print_error(str(error))  # as `ros2` does
        return 1
    except Exception as error:
        _log.debug("%s ended by an exception", session.name, exc_info=True)
        session.print_error(f"{session.name}: {str(error) or type(error).__name__}")
        return 1


_SIGNALS = {
    2: Program.interrupt,
    9: Program.kill,
    15: Program.terminate,
    18: Program.resume,
    19: Program.stop,
    20: Program.stop,
}
"""By Linux signal number: INT KILL TERM CONT STOP TSTP; what `kill -NUMBER` means on the simulated machine."""

_ENDING = frozenset({1, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13, 14})
"""Signals that end a program which does not handle them."""
