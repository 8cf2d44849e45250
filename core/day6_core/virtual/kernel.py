"""The threads of a process in virtual time: one of them runs at a time, until it waits; when all wait, the process is idle.

A thread waits for another one to wake it, for a time, or for descriptors. There is no thread for all this: the one that waits
last looks whether something can go on and, if nothing can, waits for the coordinator to say so (`World.idle`).

Everything here that the rest of the process follows is taken from Python before `follow` replaces it.
"""

from __future__ import annotations

import _thread
import heapq
from collections import deque
from collections.abc import Callable, Sequence
from itertools import count
from types import FrameType
from typing import Protocol, TypeVar

T = TypeVar("T")

_allocate_lock = _thread.allocate_lock
_get_ident = _thread.get_ident

READ_NS = 1_000
"""What reading a clock takes, so that time passes for a program that does nothing but look at it."""
FOR_EVER_NS = 10**18
"""A wait of so many nanoseconds (30 years) is one without a time limit."""
LONGEST_READING_NS = 1_000_000
"""After so much of that, others get their turn."""

Handler = Callable[[int, FrameType | None], object]


class Watch:
    """What a thread waits for outside its process: `is_there` looks once."""

    __slots__ = ("fds", "holds", "is_there", "told")

    def __init__(
        self, is_there: Callable[[], object], fds: Sequence[tuple[int, int]], *, told: bool = False, holds: bool = False
    ) -> None:
        self.is_there = is_there
        self.fds = fds
        """Descriptors with the events of poll(), for waiting in earnest."""
        self.told = told
        """Whether all that can come is announced by who sends it (`Kind.TOUCHED`)."""
        self.holds = holds
        """Whether it comes from outside the world."""


class Wait:
    """A thread, as one that waits or will."""

    __slots__ = ("deadline", "error", "gate", "ident", "late", "queued", "signalled", "waiting", "watch", "woken")

    def __init__(self, ident: int = 0) -> None:
        self.ident = ident
        """Of the thread."""
        self.gate = _allocate_lock()
        self.gate.acquire()
        self.watch: Watch | None = None
        self.error: Exception | None = None
        """What looking for it has raised; some thread has looked, but this one asked."""
        self.waiting = False
        self.queued = False
        """It has its turn soon."""
        self.woken = False
        self.late = False
        """Its time has come."""
        self.signalled = False
        self.deadline = 0


class World(Protocol):
    """Who says when a process goes on, and what time it is then."""

    def idle(self, kernel: Kernel) -> int:
        """Wait until this process has to go on; return the time, ns."""

    def want(self) -> None:
        """Something has come from outside while the process was idle. By any thread."""


class Kernel:
    """The one of this process. `world` is set before anything waits."""

    world: World

    def __init__(self) -> None:
        self.now = 0
        """ns since the world began."""
        self.yield_at = LONGEST_READING_NS
        """When who only reads the clock lets others go on."""
        self.main = Wait(_get_ident())
        self.running = self.main
        self.turns = 0
        """How often a thread has had its turn."""
        self.ran = True
        """Whether one has since somebody asked."""
        self.idling = False
        self.handlers: dict[int, Handler] = {}
        """Python functions, by signal."""
        self._arrived: deque[int] = deque()
        """Signals whose handlers have not been called yet."""
        self._in_kernel = False
        """Whether the main thread is in here, where no handler may break in."""
        self._ready: deque[Wait] = deque()
        self._timed: list[tuple[int, int, Wait]] = []
        self._numbers = count()
        self._watching: dict[Wait, None] = {}
        self._waits = {self.main.ident: self.main}
        self.wakeup_fd = -1
        """What Python writes the numbers of signals to that have handlers."""
        self.handled = 0
        """How many signals have been."""
        self.touched = True
        """Whether something has been sent to this process since it last looked for what it is told of."""

    # -- clocks --------------------------------------------------------------------------------------------------------

    def clock(self) -> int:
        """Read the clock, ns."""
        now = self.now = self.now + READ_NS
        if now >= self.yield_at:
            self.wait(0)
            return self.now
        return now

    # -- threads -------------------------------------------------------------------------------------------------------

    def mine(self) -> Wait:
        """Return the calling thread."""
        ident = _get_ident()
        wait = self._waits.get(ident)
        if wait is None:  # a thread that some library began
            wait = self._waits[ident] = Wait(ident)
        return wait

    def begin(self) -> Wait:
        """Return a new thread, which has its first turn soon: in it, `enter`."""
        wait = Wait()
        self._queue(wait)
        return wait

    def enter(self, wait: Wait) -> None:
        """Wait for the first turn of this thread."""
        wait.gate.acquire()
        wait.ident = _get_ident()
        self._waits[wait.ident] = wait

    def withdraw(self, wait: Wait) -> None:
        """Take a new thread back that could not be started."""
        self._ready.remove(wait)

    def end(self) -> None:
        """End the calling thread: others go on, and nothing of it may wait any more."""
        self._waits.pop(_get_ident(), None)
        self._hand_to(self._next())

    def forked(self) -> None:
        """In the child of a fork, only the calling thread is left."""
        mine = self.mine()
        mine.__init__(_get_ident())  # type: ignore[misc]
        self.main = self.running = mine
        self._waits = {mine.ident: mine}
        self._ready.clear()
        self._timed.clear()
        self._watching.clear()
        self._arrived.clear()
        self._in_kernel = self.idling = False
        self.now, self.yield_at = 0, LONGEST_READING_NS

    # -- waiting -------------------------------------------------------------------------------------------------------

    def wait(self, ns: int | None = None, watch: Watch | None = None) -> bool:
        """Wait until woken or until what is watched is there; False if `ns` nanoseconds have passed before.

        In the main thread, handlers of signals are called meanwhile, and what they raise comes out of here.
        """
        mine = self.mine()
        is_main = mine is self.main
        if is_main:
            self._in_kernel = True
        mine.waiting, mine.woken, mine.late = True, False, False
        if ns is not None and ns < FOR_EVER_NS:
            mine.deadline = self.now + max(0, ns)
            heapq.heappush(self._timed, (mine.deadline, next(self._numbers), mine))
        else:
            mine.deadline = -1
        if watch is not None:
            mine.watch = watch
            self._watching[mine] = None
        try:
            while True:
                following = self._next()
                if following is not mine:
                    self._hand_to(following)
                    mine.gate.acquire()
                if mine.signalled:
                    mine.signalled = False
                    self._in_kernel = False
                    self._handle()
                    self._in_kernel = True
                if mine.error is not None:
                    error, mine.error = mine.error, None
                    raise error
                if mine.woken or mine.late:
                    return mine.woken
        finally:
            mine.waiting = False
            if watch is not None:
                mine.watch = None
                self._watching.pop(mine, None)
            if is_main:
                self._in_kernel = mine.signalled = False
                self._handle()

    def look_until(
        self,
        look: Callable[[], T],
        ns: int | None = None,
        fds: Sequence[tuple[int, int]] = (),
        *,
        told: bool = False,
        holds: bool = False,
    ) -> T:
        """Return what is found by looking, once it is something or after `ns` nanoseconds; the rest as in `Watch`."""
        found = look()
        if found or ns == 0:
            return found

        def is_there() -> T:
            nonlocal found
            found = look()
            return found

        self.wait(ns, Watch(is_there, fds, told=told, holds=holds))
        return found

    def wake(self, wait: Wait) -> None:
        """Let a thread go on that waits."""
        if wait.waiting and not wait.woken and not wait.late:
            wait.woken = True
            self._queue(wait)

    def _queue(self, wait: Wait) -> None:
        if not wait.queued:
            wait.queued = True
            self._ready.append(wait)

    def _hand_to(self, wait: Wait) -> None:
        self.running = wait
        wait.gate.release()

    def _next(self) -> Wait:
        """Return who runs next, when there is somebody."""
        while True:
            if self._ready:
                self.ran = True
                self.turns += 1
                following = self._ready.popleft()
                following.queued = False
                return following
            if self.look():
                continue
            self.idling = True
            if not self._ready:  # a signal may have come before it knew that somebody has to be told
                now = self.world.idle(self)
                if now > self.now:
                    self.now = now
                self.yield_at = self.now + LONGEST_READING_NS
            self.idling = False
            self._wake_who_is_due()

    # -- what it waits for -----------------------------------------------------------------------------------------------

    def look(self) -> bool:
        """Look for what threads watch; return whether one can go on."""
        touched, self.touched = self.touched, False
        for wait in list(self._watching):
            if wait.watch is None or wait.woken or (wait.watch.told and not touched):
                continue
            try:
                is_there = wait.watch.is_there()
            except Exception as error:
                wait.error, is_there = error, True
            if is_there:
                self.wake(wait)
        return bool(self._ready)

    @property
    def has_turn(self) -> bool:
        """Whether a thread can go on."""
        return bool(self._ready)

    def told_no_more(self) -> None:
        """From now on, nobody may say what comes through descriptors."""
        for watch in self.watched:
            watch.told = watch.told and not watch.fds

    @property
    def watched(self) -> list[Watch]:
        """What is watched."""
        return [wait.watch for wait in self._watching if wait.watch is not None]

    @property
    def watches(self) -> tuple[bool, bool]:
        """Whether a thread watches something that nobody tells of, and for something from outside, as long as it takes."""
        watches = holds = False
        for wait in self._watching:
            watch = wait.watch
            if watch is not None and not watch.told:
                watches = True
                holds = holds or (watch.holds and wait.deadline < 0)
        return watches, holds

    @property
    def deadline(self) -> int | None:
        """The first time for which a thread waits."""
        timed = self._timed
        while timed:
            deadline, _, wait = timed[0]
            if wait.waiting and not wait.woken and wait.deadline == deadline:
                return deadline
            heapq.heappop(timed)
        return None

    def _wake_who_is_due(self) -> None:
        timed = self._timed
        while timed and timed[0][0] <= self.now:
            deadline, _, wait = heapq.heappop(timed)
            if wait.waiting and not wait.woken and not wait.late and wait.deadline == deadline:
                wait.late = True
                self._queue(wait)

    # -- signals -------------------------------------------------------------------------------------------------------

    def arrived(self, number: int, frame: FrameType | None) -> None:
        """Handle a signal. Python calls it in the main thread, at any moment, for all that have a handler."""
        if not self._in_kernel and self.running is self.main:
            self.handled += 1
            self.handlers[number](number, frame)
            return
        self.deliver(number)
        if self.idling:
            self.world.want()

    def deliver(self, number: int) -> None:
        """Have the main thread call a handler when it has its turn."""
        self._arrived.append(number)
        self.attend()

    def attend(self) -> None:
        """Give the main thread a turn, in which Python has it see the signals that have come."""
        self.main.signalled = True
        if self.main.waiting:
            self._queue(self.main)

    def _handle(self) -> None:
        while self._arrived:
            number = self._arrived.popleft()
            handler = self.handlers.get(number)
            self.handled += 1
            self.touched = True
            if handler is not None:
                handler(number, None)
