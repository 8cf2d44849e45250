"""The one frame timer: it runs while something changes, and not at all while nothing does.

`wake` may be called from any thread, as often as needed: it sets a flag, and only the first call after a pause costs a
trip into the event loop. Each frame clears the flag, lets the panes pull what is new, and plans the next frame; a frame that
finds the flag unset ends the series. A frame is postponed while the terminal has not yet accepted what was sent before.

Keys go before frames: a frame that is due gives way once to a key that was just read, `echo` draws what a key has written as soon
as it is there, and where few frames are drawn the next one comes early.
"""

from __future__ import annotations

import asyncio
import contextlib
import contextvars
import math
import time
from collections.abc import Callable

SLOWEST = 4.0
"""Frames per second that are drawn on the slowest link, and where nobody looks."""

BUSIEST = 8.0
"""Frames per second on a machine that is too busy for more: what moves is still seen to move."""

HURRY_SECONDS = 0.5
"""How long after a key its echo is looked for."""

WAY_SECONDS = 0.02
"""What a key and its echo need between reading and drawing; a frame that is due waits so long, or half a period."""


class Frames:
    """Calls `draw` at most `fps` times a second, when woken. With `fps` 0 only `step` draws (tests).

    `work` does what must not wait for a frame, such as reading a flood of output: it takes a few milliseconds and is called
    between frames, once `has_work` has said so after a frame. It returns the seconds until its next call (None: not before the
    next frame). `echo` draws what the last key has changed where it was typed, and nothing else; it returns whether there was
    anything.
    """

    def __init__(
        self,
        draw: Callable[[], bool],
        fps: float = 30.0,
        *,
        work: Callable[[], float | None] | None = None,
        has_work: Callable[[], bool] = lambda: True,
        echo: Callable[[], bool] = lambda: False,
        congested: Callable[[], bool] | None = None,
        blocked: Callable[[], bool] | None = None,
        failed: Callable[[Exception], None] | None = None,
    ) -> None:
        self._draw = draw
        self._work = work
        self._has_work = has_work
        self._echo = echo
        self._failed = failed
        self._congested = congested if congested is not None else lambda: False
        self._blocked = blocked if blocked is not None else self._congested
        """Whether not even an echo can be sent."""
        self._shortest = self._usual = 1.0 / fps if fps > 0 else 0.0
        self._period = self._shortest
        self._woken = False
        self._running = False
        self._due = 0.0
        self._later: float | None = None
        """When a frame is drawn even if nothing has changed until then."""
        self._sleeps = False
        """Whether the next frame planned is that one."""
        self._calm = 0
        self._typed_at = self._early_at = -math.inf
        """When the last key was read, and when a frame was last drawn early for one."""
        self._awaits_echo = self._glances = False
        """Whether a key's echo has not been drawn, and whether the loop is about to look for it."""
        self._has_waited = False
        """Whether the next frame has given way to a key."""
        self._held_period: float | None = None
        """The period when the terminal last took no more, None while it does."""
        self._loop: asyncio.AbstractEventLoop | None = None
        self._handle: asyncio.TimerHandle | None = None
        self._slice: asyncio.TimerHandle | None = None
        self._works_soon = False
        """Whether the loop is about to call `work` because somebody waits for it."""
        self._context: contextvars.Context | None = None
        self.drawn = 0
        """Frames drawn so far."""

    @property
    def rate(self) -> float:
        """Frames per second allowed at present."""
        return 1.0 / self._period if self._period else 0.0

    def attach(self) -> None:
        """Start working; call it in the event loop, inside the application's context."""
        self._loop = asyncio.get_running_loop()
        self._context = contextvars.copy_context()
        if self._woken:
            self._begin()

    def rest(self, resting: bool) -> None:
        """Draw as seldom as possible from now on, as nobody sees it; or as usual again, at once."""
        if self._usual:
            self._shortest = self._period = 1.0 / SLOWEST if resting else self._usual
            if not resting and self._handle is not None:
                self._handle.cancel()
                self._plan(time.monotonic())
            self.wake()

    def detach(self) -> None:
        """Stop for good."""
        self._loop = None
        if self._handle is not None:
            self._handle.cancel()
            self._handle = None
        if self._slice is not None:
            self._slice.cancel()
            self._slice = None

    def wake(self) -> None:
        """Something changed: draw a frame soon. Any thread."""
        self._woken = True
        loop = self._loop
        if not self._running and loop is not None and self._shortest:
            self._running = True
            try:
                loop.call_soon_threadsafe(self._begin, context=self._context)
            except RuntimeError:
                # The loop closed between the check and the call: the desktop is being closed.
                self._running = False
        elif self._awaits_echo and not self._glances and loop is not None:
            self._glances = True
            with contextlib.suppress(RuntimeError):
                loop.call_soon_threadsafe(self._glance, context=self._context)

    def hold(self) -> None:
        """The terminal takes no more for now: the next frame comes when it does. In the event loop."""
        if self._held_period is None:
            self._held_period = self._period

    def relieve(self) -> None:
        """The terminal may take more again: a frame that waits for that comes at once if it does. Any thread."""
        loop = self._loop
        if self._held_period is not None and loop is not None:
            with contextlib.suppress(RuntimeError):
                loop.call_soon_threadsafe(self._go_on, context=self._context)

    def _go_on(self) -> None:
        if self._held_period is not None and self._handle is not None:
            self._period, self._held_period = self._held_period, None
            self._handle.cancel()
            self._plan(time.monotonic())

    def typed(self) -> None:
        """A key was read. Any thread."""
        self._typed_at = time.monotonic()

    def untouched_for(self, now: float) -> float:
        """Seconds since the last key."""
        return now - self._typed_at

    def hurry(self, *, echoes: bool = True) -> None:
        """A key is handed on, to what `echoes` or not: draw what comes of it before anything else. In the event loop."""
        self.typed()
        self._awaits_echo = echoes
        early = self._typed_at + self._usual
        if (
            self._handle is not None
            and not self._sleeps
            and self._due > early
            and self._typed_at - self._early_at > 1.0 / BUSIEST  # a key that is held down asks for no more than that
        ):
            self._early_at, self._has_waited = self._typed_at, True
            self._handle.cancel()
            self._plan(early)

    def _glance(self) -> None:
        """Draw the echo of a key if it has come."""
        self._glances = False
        if self._loop is None or not self._running or self._blocked():
            return
        try:
            drawn = self._echo()
        except Exception as error:
            self._fail(error)
            drawn = True
        if drawn or time.monotonic() - self._typed_at > HURRY_SECONDS:
            self._awaits_echo = False

    def _gives_way(self, now: float) -> bool:
        """Whether a key is on its way that the next frame has not given way to; it then has."""
        until = self._typed_at + max(WAY_SECONDS, self._period / 2)
        if self._has_waited or now >= until:
            return False
        self._has_waited = True
        self._plan(until)
        return True

    def wake_after(self, seconds: float) -> None:
        """Draw a frame in so long even if nothing changes until then: `draw` says what it has put off. In the event loop."""
        due = time.monotonic() + seconds
        self._later = due if self._later is None else min(due, self._later)

    def step(self) -> None:
        """Draw one frame now."""
        self._woken = False
        self._later = None
        self.drawn += 1
        if self._draw():
            self._woken = True

    def _begin(self) -> None:
        if self._sleeps and self._handle is not None:
            self._handle.cancel()
            self._handle = None
        if self._handle is None and self._loop is not None:
            self._running = True
            self._has_waited = not self._awaits_echo  # who wakes us has worked on the key already
            self._plan(max(time.monotonic(), self._due))

    def _plan(self, due: float) -> None:
        assert self._loop is not None
        self._sleeps = False
        self._due = due
        delay = max(0.0, due - time.monotonic())
        self._handle = self._loop.call_later(delay, self._tick, context=self._context)

    def _sleep(self, due: float) -> None:
        """Wait until `due`, or until something changes before."""
        usual = self._due
        self._plan(due)
        self._due, self._sleeps = usual, True

    def _tick(self) -> None:
        self._handle = None
        if self._loop is None:
            return
        if self._sleeps:
            self._sleeps, self._woken, self._running = False, True, True
            self._due = self._later or self._due
        now = time.monotonic()
        if self._congested():
            self.hold()
            self._adapt(self._period, SLOWEST)
            self._plan(now + self._period)
            return
        if self._woken and self._gives_way(now):
            return
        self._has_waited, self._held_period = False, None
        self._adapt(now - self._due, BUSIEST)
        if self._woken:
            try:
                self.step()
            except Exception as error:
                self._fail(error)
            ended = time.monotonic()
            # As long as a frame takes on a busy machine, keys and programs get in between.
            self._plan(
                max(now, self._due + self._period, ended + max(self._period / 4, min(ended - now, 1.0 / BUSIEST)))
            )
            if self._slice is None and self._has_work():
                self._plan_slice(0.0)
            return
        self._running = False
        if self._woken:
            # A thread woke us between the check of the flag and the line above.
            self._running = True
            self._plan(now + self._period)
        elif self._later is not None:
            self._sleep(self._later)

    def _plan_slice(self, delay: float) -> None:
        if self._work is not None and self._loop is not None:
            self._slice = self._loop.call_later(delay, self._work_on, context=self._context)

    def _work_on(self) -> None:
        self._slice = None
        if self._work is None or self._loop is None:
            return
        try:
            delay = self._work()
        except Exception as error:
            self._fail(error)
            return
        if delay is not None:
            self._plan_slice(delay)

    def work_soon(self) -> None:
        """Somebody waits for `work`: call it before anything else. Any thread."""
        loop = self._loop
        if loop is not None and self._shortest and not self._works_soon:
            self._works_soon = True
            with contextlib.suppress(RuntimeError):
                loop.call_soon_threadsafe(self._work_now, context=self._context)

    def _work_now(self) -> None:
        self._works_soon = False
        if self._slice is not None:
            self._slice.cancel()
        self._work_on()

    def _fail(self, error: Exception) -> None:
        """Tell of an error that is being handled; asyncio would print it over the screen."""
        if self._failed is None:
            raise error
        self._failed(error)

    def _adapt(self, late: float, least: float) -> None:
        """Halve the rate, down to `least`, when frames come late by most of a period; double it after two calm seconds."""
        if late > 0.8 * self._period and late > 0.02:
            self._period = max(self._period, min(self._period * 2, 1.0 / least))
            self._calm = 0
        else:
            self._calm += 1
            if self._period > self._shortest and self._calm * self._period > 2.0:
                self._period = max(self._period / 2, self._shortest)
                self._calm = 0
