"""Runs all cooperative programs on one thread, at exact times of the world clock.

Tasks (`day6_core.session.task`) wait for signals and for times of the world clock. The scheduler takes the earliest deadline that
wall time has reached, sets the clock to exactly that deadline, runs everything that is due and ready until nothing is left,
and goes on to the next. With nothing to do it blocks in its inbox, without polling. Other threads touch it only through
`call_soon_threadsafe` and `Signal.set`. It does not use asyncio, whose import would slow down every program process and whose
clock cannot be set.
"""

from __future__ import annotations

import contextlib
import heapq
import itertools
import logging
import math
import os
import threading
import time
from collections import deque
from collections.abc import Callable, Coroutine
from queue import Empty
from typing import Any

from day6_core.inbox import Inbox
from day6_core.session import blocking_files
from day6_core.session.clock import WorldClock, nanoseconds
from day6_core.session.task import YIELD, Task, Wait
from day6_core.virtual.surroundings import is_virtual

MAX_LAG_NS = nanoseconds(0.25)
"""A world further behind wall time than this drops the lag instead of catching up."""

STEPS_PER_DEADLINE = 10_000
"""Steps that programs which keep waking each other get at one moment before time moves on."""

SETTLE_SECONDS = 0.02
"""Wall seconds for which programs that never wait may delay anything else: a Ctrl-C, the next deadline."""

LATE_NS = nanoseconds(0.1)
"""A world further behind than this leaves time between its deadlines while somebody types: the machine is too busy for both."""

TYPING_SECONDS = 1.0
"""For how long after a key."""

LONGEST_PAUSE = 0.05
"""Wall seconds between two deadlines then, at most."""

SHORT_NS = nanoseconds(0.001)
"""Who keeps waiting for less than this (a timer of a nanosecond) has to leave time to the others."""

SHORT_WAITS = 20
"""So many in a row are as short as the program wants them."""

SHARE_LEFT = 4
"""After that it waits this many times as long as its last step took."""

PAUSE_AFTER_FAILURE = 0.05
"""Wall seconds that the thread of all programs pauses after a bug in it, which may recur every time."""

LONGEST_WAIT = 0.1 if os.name == "nt" else math.inf
"""The most seconds that the main thread waits at a time: on Windows a thread that waits for a lock does not notice Ctrl-C."""

BUSY_ANNOUNCEMENT = 0.03
"""Wall seconds after which a scheduler that never idles announces activity."""

STUCK_SECONDS = 0.5
"""Wall seconds of one step after which Ctrl-C is raised in the middle of it."""

_log = logging.getLogger(__name__)


class Scheduler:
    """Owns a world clock and the tasks that wait on it. Run it with `start` (own thread), `run` or `advance` (the caller's)."""

    def __init__(self, clock: WorldClock, *, may_wait: bool = False) -> None:
        self.clock = clock
        self.may_wait = may_wait
        """Whether its program may block: it is the only one, at a real terminal, and may for instance open a named pipe."""
        clock.on_change = self.wake
        self._inbox: Inbox[Callable[[], None] | None] = Inbox()
        self._ready: deque[tuple[Task, int, bool]] = deque()
        self._deadlines: list[tuple[int, int, Task, int]] = []
        self._order = itertools.count()
        self._tasks: set[Task] = set()
        self._unbegun: set[Task] = set()
        """Those whose first step has not been taken."""
        self._running: Task | None = None
        self._step_began = 0.0
        self._thread_id: int | None = None
        self._thread: threading.Thread | None = None
        self._stopping = False
        self._worked: bool = False
        """Whether anything ran since the last call of `on_activity`."""
        self._announced = 0.0
        self._typed_until = 0.0
        self.on_activity: Callable[[], None] | None = None
        """Called on the scheduler's thread after something ran: a screen may have to be drawn. Must return at once."""

    # -- from any thread -----------------------------------------------------------------------------------------------

    def call_soon_threadsafe(self, function: Callable[[], None]) -> None:
        """Run `function` on the scheduler's thread, soon. Safe in signal handlers too."""
        self._inbox.put(function)

    def give_way(self) -> None:
        """A key was typed: what comes of it goes before a world that is late."""
        self._typed_until = time.monotonic() + TYPING_SECONDS

    def wake(self) -> None:
        """Make a waiting scheduler read its clock again."""
        self._inbox.put(None)

    @property
    def thread_number(self) -> int | None:
        """The system-wide number of the thread of `start`; None before it runs."""
        return self._thread.native_id if self._thread is not None else None

    @property
    def stuck_for(self) -> float:
        """Wall seconds since the current step began; 0 between steps."""
        return time.monotonic() - self._step_began if self._running is not None else 0.0

    def insist(self) -> None:
        """Ctrl-C was pressed: soon raise KeyboardInterrupt in a program that does not reach its next wait. Any thread.

        Such a program holds up all others, and the Ctrl-C too. A call into C is interrupted when it returns.
        """
        if self.stuck_for > STUCK_SECONDS / 2:
            threading.Thread(target=self._break_in, args=(self._step_began,), name="day6-insist", daemon=True).start()

    def _break_in(self, step: float) -> None:
        time.sleep(STUCK_SECONDS / 2)
        if self._running is not None and self._step_began == step and self._thread_id is not None:
            import ctypes

            ctypes.pythonapi.PyThreadState_SetAsyncExc(
                ctypes.c_ulong(self._thread_id), ctypes.py_object(KeyboardInterrupt)
            )

    def spawn(self, coroutine: Coroutine[Any, Any, Any], name: str = "task") -> Task:
        """Start a task; its first step is taken in the next turn."""
        task = Task(self, coroutine, name)
        self._unbegun.add(task)

        def enter() -> None:
            self._tasks.add(task)
            self._ready.append((task, task._ticket, True))

        self.call(enter)
        return task

    # -- running -------------------------------------------------------------------------------------------------------

    def start(self) -> None:
        """Run in a new thread until `stop`."""
        if self._thread is None:
            self._stopping = False
            self._thread = threading.Thread(target=self._thread_main, name="day6-programs", daemon=True)
            self._thread.start()

    def stop(self, timeout: float = 2.0) -> None:
        """End the thread of `start`, waiting at most `timeout` seconds. Unfinished tasks stay where they are."""
        self._stopping = True
        self.wake()
        thread = self._thread
        if thread is not None and thread is not threading.current_thread():
            thread.join(timeout)
            self._thread = None

    def close(self) -> None:
        """Stop for good: what was started too late to take a step never will."""
        self.stop()
        for task in tuple(self._unbegun):
            task._coroutine.close()  # else Python complains at its end that nobody awaited it
        self._unbegun.clear()

    def run(self, until: Callable[[], bool], timeout: float | None = None) -> bool:
        """Run on the caller's thread, paced by the wall, until `until()` holds; False after `timeout` wall seconds."""
        give_up = None if timeout is None else time.monotonic() + timeout
        previous, self._thread_id = self._thread_id, threading.get_ident()
        end = self._without_waits()
        try:
            while not until():
                left = LONGEST_WAIT if give_up is None else min(give_up - time.monotonic(), LONGEST_WAIT)
                if left <= 0:
                    return False
                self._turn(wait=True, longest=left)
            return True
        finally:
            end()
            self._thread_id = previous

    def advance(self, seconds: float = 0.0) -> None:
        """For tests and a stepped world: move the target on and run everything due until then, on the caller's thread."""
        previous, self._thread_id = self._thread_id, threading.get_ident()
        end = self._without_waits()
        try:
            while self._turn(wait=False, longest=math.inf):
                pass  # anything ready at this moment runs before time moves
            if seconds:
                self.clock.step(seconds)
                while self._turn(wait=False, longest=math.inf):
                    pass
        finally:
            end()
            self._thread_id = previous

    def _without_waits(self) -> Callable[[], None]:
        """Until the returned function is called, opening a blocking file fails on this thread, and tests watch it."""
        if self.may_wait:
            return _nothing
        opened = blocking_files.end if blocking_files.begin() else _nothing
        watched = _watched()

        def end() -> None:
            opened()
            watched()

        return end

    def _thread_main(self) -> None:
        self._thread_id = threading.get_ident()
        end = self._without_waits()
        while not self._stopping:
            try:
                self._turn(wait=True, longest=math.inf)
            except KeyboardInterrupt:
                continue  # from `insist`, for a step that ended at this very moment
            except BaseException:
                # All programs need this thread, and the others have not failed. A panic in Zenoh isn't an Exception.
                _log.exception("a turn of the scheduler failed")
                with contextlib.suppress(Empty):
                    self._run_item(self._inbox.get(timeout=PAUSE_AFTER_FAILURE))
        end()
        self._thread_id = None

    def _turn(self, *, wait: bool, longest: float) -> bool:
        """Run what is ready, or the next deadline, or wait. Returns False if there was nothing to do and `wait` is false."""
        if (self._drain() or self._ready) and self._settle(paced=wait):
            return True
        # Either nothing is ready, or programs keep waking each other; in both cases time has to go on.
        deadline = self._next_deadline()
        target = self.clock.target_ns()
        if deadline is not None and deadline <= target:
            if wait and target - deadline > MAX_LAG_NS:
                self.clock.fall_behind(deadline)
            began = time.monotonic()
            self.clock.hold(deadline)
            self._release_due(deadline)
            self._settle(paced=wait)
            now = time.monotonic()
            if now - self._announced > BUSY_ANNOUNCEMENT:
                self.announce_activity()
            if wait and now < self._typed_until and target - deadline > LATE_NS:
                self._pause(min(now - began, LONGEST_PAUSE))
            return True
        if self._ready:
            return True
        if not wait:
            self.clock.hold(target)
            self.clock.release(target)
            return False
        timeout = None if deadline is None else self.clock.wall_seconds_until(deadline)
        if longest < math.inf:
            timeout = longest if timeout is None else min(timeout, longest)
        self.clock.release(deadline)
        if self._worked:
            self._worked = False
            self.announce_activity()
        try:
            item = self._inbox.get(timeout=timeout)
        except Empty:
            return True
        self._hold_at_wall(deadline)
        self._run_item(item)
        return True

    def _pause(self, seconds: float) -> None:
        """Leave the processor to the screen, unless something comes from outside."""
        with contextlib.suppress(Empty):
            item = self._inbox.get(timeout=seconds)
            self._hold_at_wall(self._next_deadline())
            self._run_item(item)

    def _drain(self) -> bool:
        """Run the calls of other threads. The clock then reads wall time, but never past a deadline that has not run."""
        if self._inbox.empty():
            return False
        self._hold_at_wall(self._next_deadline())
        for _ in range(self._inbox.qsize()):
            try:
                self._run_item(self._inbox.get_nowait())
            except Empty:
                break
        return True

    def _hold_at_wall(self, deadline: int | None) -> None:
        target = self.clock.target_ns()
        self.clock.hold(target if deadline is None else min(target, deadline))

    def _run_item(self, item: Callable[[], None] | None) -> None:
        if item is None:
            return
        self._worked = True
        try:
            item()
        except Exception:
            # A broken callback of one program must not end the thread that runs all the others.
            _log.exception("a call into the scheduler failed")

    def announce_activity(self) -> None:
        """Announce that a view may have to be redrawn (any thread). Anything that runs after this is announced again."""
        self._announced = time.monotonic()
        notify = self.on_activity
        if notify is not None:
            notify()

    def _settle(self, *, paced: bool) -> bool:
        """Step tasks until none is ready; False if that took too many steps or (`paced`) too long, and some still are."""
        self._worked = True
        ready = self._ready
        began = time.monotonic() if paced else math.inf
        for _ in range(STEPS_PER_DEADLINE):
            if not ready or self._step_began - began > SETTLE_SECONDS:
                break
            task, ticket, outcome = ready.popleft()
            if ticket == task._ticket and not task.finished:
                if task._held:
                    task._held_wake = outcome
                else:
                    self._step(task, outcome)
        return not ready

    # -- tasks ---------------------------------------------------------------------------------------------------------

    def _step(self, task: Task, outcome: bool) -> None:
        task._ticket += 1
        task._waiting = False
        self._step_began = time.monotonic()
        self._running = task
        coroutine = task._coroutine
        try:
            if not task._begun:
                task._begun = True
                self._unbegun.discard(task)
                wait = coroutine.send(None)
            elif task._pending:
                wait = coroutine.throw(task._pending.popleft())
            else:
                wait = coroutine.send(outcome)
        except StopIteration as stop:
            self._finish(task, stop.value, None)
            return
        except BaseException as error:
            self._finish(task, None, error)
            return
        finally:
            self._running = None
        task._waiting = True
        self._await(task, wait)

    def _await(self, task: Task, wait: Any) -> None:
        ticket = task._ticket
        if task._pending:
            self._ready.append((task, ticket, False))
            return
        if wait is YIELD or wait is None:
            self._ready.append((task, ticket, True))
            return
        if not isinstance(wait, Wait):
            # A future of rclpy: awaited directly it yields itself (or something with the same method).
            wait.add_done_callback(lambda _: self._wake(task, ticket))
            return
        if wait.deadline_ns is not None:
            deadline = self._allowed(task, wait.deadline_ns)
            if len(self._deadlines) > 64 + 4 * len(self._tasks):
                self._forget_stale_deadlines()
            heapq.heappush(self._deadlines, (deadline, next(self._order), task, ticket))
        if wait.signal is not None:
            wait.signal._waiters[task] = ticket
            if wait.signal._set:
                self._ready.append((task, ticket, True))

    def _allowed(self, task: Task, deadline: int) -> int:
        """Return when a wait ends: at its deadline, unless the world would stand still for one task that runs too often.

        The clock passes no deadline that has not run, so that the next one would always be a nanosecond ahead.
        """
        now = self.clock.steady_ns()
        if deadline - now >= SHORT_NS:
            task._short_waits = 0
            return deadline
        task._short_waits += 1
        if task._short_waits <= SHORT_WAITS or not self.clock.is_paced:
            return deadline
        took = nanoseconds((time.monotonic() - self._step_began) * self.clock.speed)
        return max(deadline, now + min(SHARE_LEFT * took, SHORT_NS))

    def _finish(self, task: Task, result: Any, error: BaseException | None) -> None:
        task.result = result
        task.exception = error
        task._ticket += 1
        self._tasks.discard(task)
        self._unbegun.discard(task)
        task.done.set()
        if task.on_done is not None:
            self._run_item(lambda: task.on_done(task) if task.on_done else None)

    def _next_deadline(self) -> int | None:
        deadlines = self._deadlines
        while deadlines:
            deadline, _, task, ticket = deadlines[0]
            if ticket == task._ticket and not task.finished:
                return deadline
            heapq.heappop(deadlines)
        return None

    def _forget_stale_deadlines(self) -> None:
        """Drop deadlines of waits that a signal has already ended, before they pile up."""
        self._deadlines = [entry for entry in self._deadlines if entry[3] == entry[2]._ticket and not entry[2].finished]
        heapq.heapify(self._deadlines)

    def _release_due(self, now: int) -> None:
        deadlines = self._deadlines
        while deadlines and deadlines[0][0] <= now:
            _, _, task, ticket = heapq.heappop(deadlines)
            if ticket == task._ticket:
                self._ready.append((task, ticket, False))

    def call(self, function: Callable[[], None]) -> None:
        """Run `function` on the scheduler's thread: now if this is it, else soon."""
        if threading.get_ident() == self._thread_id:
            function()
        else:
            self._inbox.put(function)

    def _wake(self, task: Task, ticket: int) -> None:
        if threading.get_ident() == self._thread_id:
            self._ready.append((task, ticket, True))
        else:
            self._inbox.put(lambda: self._ready.append((task, ticket, True)))

    def _throw(self, task: Task, error: BaseException) -> None:
        if task.finished:
            return
        task._pending.append(error)
        if task._waiting:
            task._ticket += 1
            self._ready.append((task, task._ticket, False))

    def _hold(self, task: Task) -> None:
        task._held = True

    def _release(self, task: Task) -> None:
        task._held = False
        if task._held_wake is not None:
            self._ready.append((task, task._ticket, task._held_wake))
            task._held_wake = None


def _watched() -> Callable[[], None]:
    """In tests and for debugging: let `day6_core.session.watch` check this thread until the returned function is called."""
    if (
        "DAY6_WATCH" not in os.environ or is_virtual()
    ):  # its samples would be far apart in the real time that it is about
        return _nothing
    from day6_core.session import watch

    return watch.end if watch.begin() else _nothing


def _nothing() -> None:
    """Do nothing, where there is nothing to end."""
