"""Waits until an application under test has nothing left to do, instead of until the processor looks idle.

Textual's own way sleeps at least 20 ms a time and asks how busy the process was: three quarters of these tests' time, and on a
loaded machine no answer. Here the event loop says it: when none of its callbacks is ready, every task waits for a timer, another
thread or the test. Of the timers, those of Textual that draw, resize and animate are not waited for but called: what they do is
the end of what was begun, however late the machine would be with it.
"""

from __future__ import annotations

import asyncio
import math

import textual.app
import textual.pilot
from textual._context import active_app
from textual.app import App
from textual.pilot import Pilot

from tests.support.waiting import Deadline
from tests.tui.stepped_time import move_on

ROUNDS = 256
"""Turns of the event loop between two looks at the clock, which cost more than a turn."""


async def wait_until_settled(min_sleep: float = 0, max_sleep: float = 1) -> None:
    """Do what `textual._wait.wait_for_idle` is for, however long it takes; AssertionError when it never ends.

    Stepped time goes on a little by it.
    """
    app, loop = active_app.get(), asyncio.get_running_loop()
    ready = loop._ready  # type: ignore[attr-defined]
    deadline = Deadline()
    while True:
        for _ in range(ROUNDS):
            await asyncio.sleep(0)
            # This task's own callback is the one that runs; those behind it are still in the queue.
            if not ready and not _finish(app):
                move_on()
                return
        if deadline.is_over():
            raise AssertionError(f"the application does not come to rest; ready are {list(ready)}")


def _finish(app: App[object]) -> bool:
    """Do at once what a timer of Textual would do next; returns whether there was anything."""
    if not app._running:
        return False
    if app._resize_event is not None:
        app._check_resize()  # up to 8 ms later
        return True
    if not app.animator._complete_event.is_set() and not app.animator._scheduled:
        for animation in app.animator._animations.values():
            animation.start_time = -math.inf  # type: ignore[attr-defined]
        app.animator()  # each 1/60 s, until the animation's time is over
        return True
    for screen in app.screen_stack:
        if screen.is_running and screen._update_timer._active.is_set():
            screen._on_timer_update()  # up to 33 ms later; it pauses its timer
            return True
    return False


async def _settle_screen(pilot: Pilot[object], timeout: float = 0) -> bool:
    await wait_until_settled()
    return pilot.app._exception is None


def install() -> None:
    """Let Textual's pilot wait like this."""
    textual.app.wait_for_idle = textual.pilot.wait_for_idle = wait_until_settled  # type: ignore[attr-defined]
    Pilot._wait_for_screen = _settle_screen  # type: ignore[method-assign]
