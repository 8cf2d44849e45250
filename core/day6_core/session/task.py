"""Signals, waits and tasks: how programs wait for each other and for times of the world clock.

A task is a coroutine that waits for two things only, a `Signal` and a time. `day6_core.session.scheduler` runs it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Coroutine, Generator
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from day6_core.session.scheduler import Scheduler

_Result = TypeVar("_Result")


class Signal:
    """A flag that tasks wait for and any thread may set; it stays set until `clear`."""

    __slots__ = ("_set", "_waiters")

    def __init__(self) -> None:
        self._set = False
        self._waiters: dict[Task, int] = {}

    def set(self) -> None:
        """Set the flag and wake every task that waits for it (any thread)."""
        # The order matters: a waiter enters the table before it reads the flag, so one of the two sees the other.
        self._set = True
        if self._waiters:
            waiters, self._waiters = self._waiters, {}
            for task, ticket in list(waiters.items()):
                task.scheduler._wake(task, ticket)

    def clear(self) -> None:
        """Clear the flag: tasks that wait from now on wait for the next `set`."""
        self._set = False

    def is_set(self) -> bool:
        """Return whether the flag is set."""
        return self._set


class Wait:
    """Yielded by a task to the scheduler: wake it by this signal or at this steady world time (ns), whichever is first."""

    __slots__ = ("deadline_ns", "signal")

    def __init__(self, signal: Signal | None, deadline_ns: int | None) -> None:
        self.signal = signal
        self.deadline_ns = deadline_ns

    def __await__(self) -> Generator[Wait, bool, bool]:
        return (yield self)


YIELD = Wait(None, 0)
"""Yielded by a task that only lets others run."""


class TaskCancelled(BaseException):
    """Thrown into a task that is ended from outside; a BaseException, so that no `except Exception` of a program catches it."""


class Task:
    """A running coroutine. `done` is set when it has ended; `result` or `exception` then holds its outcome."""

    def __init__(self, scheduler: Scheduler, coroutine: Coroutine[Any, Any, Any], name: str) -> None:
        self.scheduler = scheduler
        self.name = name
        self.done = Signal()
        self.result: Any = None
        self.exception: BaseException | None = None
        self.on_done: Callable[[Task], None] | None = None
        """Called once, on the scheduler's thread, when the task has ended."""
        self._coroutine = coroutine
        self._ticket = 0
        """Number of the current wait: a wake-up with an older number comes too late and is ignored."""
        self._pending: deque[BaseException] = deque()
        self._begun = False
        self._waiting = True
        self._held = False
        self._held_wake: bool | None = None
        self._short_waits = 0
        """How many waits in a row were for less than `scheduler.SHORT_NS`."""

    @property
    def finished(self) -> bool:
        """Whether the task has ended, however it ended."""
        return self.done.is_set()

    def throw(self, error: BaseException) -> None:
        """Raise `error` in the task where it waits (any thread; at its next wait if it is running)."""
        self.scheduler.call(lambda: self.scheduler._throw(self, error))

    @property
    def undelivered(self) -> BaseException | None:
        """The first error given to `throw` that has not been raised yet."""
        return self._pending[0] if self._pending else None

    def cancel(self) -> None:
        """End the task from outside; its `finally` blocks run."""
        self.throw(TaskCancelled())

    def hold(self) -> None:
        """Stop stepping the task (as SIGSTOP does) until `release`."""
        self.scheduler.call(lambda: self.scheduler._hold(self))

    def release(self) -> None:
        """Step the task again after `hold`; a wake-up that came meanwhile is delivered now."""
        self.scheduler.call(lambda: self.scheduler._release(self))

    async def join(self) -> None:
        """Wait until the task has ended, however it ended."""
        while not self.done.is_set():
            await Wait(self.done, None)


async def wait_for(signal: Signal, deadline_ns: int | None = None) -> bool:
    """Wait for `signal` until the steady world time `deadline_ns`; True if it is set, False if the time was reached first."""
    if signal.is_set():
        return True
    return await Wait(signal, deadline_ns)


async def sleep_until(deadline_ns: int) -> None:
    """Wait until the steady world time `deadline_ns`; the clock then reads exactly that (unless it was already past)."""
    await Wait(None, deadline_ns)


async def let_others_run() -> None:
    """Go to the end of the queue of ready tasks."""
    await YIELD


async def in_turns(work: Generator[None, None, _Result]) -> _Result:
    """Run a generator, letting others run at each yield; return its return value."""
    while True:
        try:
            next(work)
        except StopIteration as end:
            result: _Result = end.value
            return result
        await let_others_run()
