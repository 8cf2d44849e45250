"""Runs a program in its session and turns its end into an exit status and messages as a shell knows them."""

from __future__ import annotations

import contextlib
import logging

from day6_core.graph.domain import DomainError
from day6_core.reason import named_reason
from day6_core.session.session import Crash, KilledBySignal, Main, Session
from day6_core.session.streams import WriteError
from day6_core.session.task import Signal, Task, TaskCancelled, wait_for

_log = logging.getLogger(__name__)

SIGINT = 2
SIGKILL = 9  # signal.SIGKILL does not exist on Windows
SIGPIPE = 13
SIGTSTP = 20


class Program:
    """A running cooperative program. `status` is None until it has ended; `killed_by` is the signal that ended it, or 0."""

    def __init__(self, session: Session, main: Main) -> None:
        self.session = session
        self.status: int | None = None
        self.killed_by = 0
        self.stopped_by = 0
        """The signal that has stopped it, 0 while it may run."""
        session.on_own_stop = self._own_stop
        self.done = Signal()
        self._watchers: list[Signal] = []
        self._task: Task = session.scheduler.spawn(self._run(main), session.name)
        session.task = self._task

    @property
    def stopped(self) -> bool:
        return self.stopped_by != 0

    @property
    def pid(self) -> int:
        """The process number on the simulated machine."""
        return self.session.pid

    async def wait(self) -> int:
        """Wait for the end; return the exit status (128 + signal for a program that was killed by a signal)."""
        await wait_for(self.done)
        assert self.status is not None
        return self.status

    def send(self, number: int) -> None:
        """Deliver a signal by its number; signals whose default action is to be ignored are ignored."""
        action = _SIGNALS.get(number)
        if number in _STOPPING:
            self.stop(number)
        elif action is not None:
            action(self)
        elif number in _ENDING:
            self._task.throw(KilledBySignal(number))

    def interrupt(self) -> None:
        """SIGINT: raise KeyboardInterrupt in the program where it waits, unless a command that it runs takes it."""
        self.session.interrupt()

    def terminate(self) -> None:
        """SIGTERM: raise `Terminated` in the program where it waits."""
        self.session.terminate()

    def kill(self) -> None:
        """SIGKILL: cancel the program's task; only `finally` blocks run."""
        self._task.cancel()

    def stop(self, number: int = SIGTSTP) -> None:
        """SIGTSTP, SIGSTOP …: the program takes no step until `resume`; its watchers are notified."""
        self.stopped_by = self.stopped_by or number
        self.session.stop()
        self._notify_watchers()

    def resume(self) -> None:
        """SIGCONT: let a stopped program go on."""
        self.stopped_by = 0
        self.session.resume()
        self._notify_watchers()

    def _own_stop(self, number: int) -> None:
        if number:
            self.stop(number)
        else:
            self.resume()

    async def _run(self, main: Main) -> None:
        try:
            self.status = await _status_of(self.session, main)
            if self._task.undelivered is not None and not self.session.stopping:
                raise self._task.undelivered  # a signal came before the end, and there was no wait to raise it in
        except KeyboardInterrupt:
            self._killed(SIGINT)
        except KilledBySignal as end:
            self._killed(end.number)
        except TaskCancelled:
            self._killed(SIGKILL)
        except BrokenPipeError:
            # Nobody reads its output any more: a real program gets SIGPIPE and ends silently.
            self._killed(SIGPIPE)
        finally:
            if self.status is None:
                self.status = 1
            self.session.status = self.status
            self.session.close()
            self.done.set()
            self._notify_watchers()

    def watch(self, signal: Signal) -> None:
        """Set `signal` whenever the program ended, was stopped or goes on (at once, if it has ended)."""
        self._watchers.append(signal)
        if self.done.is_set():
            signal.set()

    def _notify_watchers(self) -> None:
        for signal in self._watchers:
            signal.set()

    def _killed(self, number: int) -> None:
        self.killed_by = number
        self.status = 128 + number


async def _status_of(session: Session, main: Main) -> int:
    """Return the exit status of `main`, taking into account output that could not be written."""
    try:
        status = await _end_of(session, main)
        session.stdout.flush()
    except WriteError as error:
        status = session.on_write_error(session, error)
    with contextlib.suppress(WriteError):  # there is nowhere left to report it
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
    except Crash as crash:
        session.print_error(crash.report)
        raise KilledBySignal(crash.number) from None
    except DomainError as error:
        session.print_error(str(error))  # as `ros2` does
        return 1
    except Exception as error:
        _log.debug("%s ended by an exception", session.name, exc_info=True)
        session.print_error(f"{session.name}: {named_reason(error)}")
        return 1


_SIGNALS = {
    2: Program.interrupt,
    9: Program.kill,
    15: Program.terminate,
    18: Program.resume,
}
"""By Linux signal number: INT KILL TERM CONT; the effect of `kill -NUMBER` on the simulated machine."""

_STOPPING = frozenset({19, 20, 21, 22})
"""STOP TSTP TTIN TTOU."""

_ENDING = frozenset({1, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13, 14})
"""Other signals that end a program."""
