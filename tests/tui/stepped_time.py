"""Time that goes on only while an application has nothing to do, so that no test knows how fast its machine is.

Notices, double clicks, pictures that are drawn a few times a second: all of this asks `time.monotonic`, and so do the timers of
the event loop. Here that clock stands still while something is worked off (which takes no `time.thread_time`), and when the loop
would wait for a timer it is that timer's time at once. What is given to a thread (Textual reads Markdown there) is done at once,
too. A test that wants the real clocks has imported them by name.
"""

from __future__ import annotations

import asyncio
import math
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any
from unittest.mock import patch

import textual._time
import textual.timer

from day6_tui.screen import key_order

STEP = 1 / 64
"""Seconds; sums of it are exact."""


class SteppedTime:
    """What `time.monotonic` returns."""

    def __init__(self) -> None:
        self.now = math.ceil(time.monotonic())  # what was noted before lies before it

    def __call__(self) -> float:
        return self.now


_clock: SteppedTime | None = None


def move_on(seconds: float = STEP) -> None:
    """Let time go on, if it is a stepped one; what is due then comes with the next turn of the event loop."""
    if _clock is not None:
        _clock.now += seconds


@contextmanager
def stepped_time() -> Iterator[SteppedTime]:
    """Step the time of the running event loop and of all that asks `time.monotonic`."""
    global _clock
    clock, loop = SteppedTime(), asyncio.get_running_loop()
    selector: Any = loop._selector  # type: ignore[attr-defined]
    select = selector.select

    def select_or_move_on(timeout: float | None = None) -> Any:
        if timeout is None or timeout <= 0:
            return select(timeout)
        if not (events := select(0)):
            clock.now += timeout
        return events

    def run_at_once(executor: object, function: Callable[..., Any], *arguments: Any) -> asyncio.Future[Any]:
        done = loop.create_future()
        try:
            done.set_result(function(*arguments))
        except Exception as error:
            done.set_exception(error)
        return done

    _clock = clock
    try:
        with (
            patch.object(time, "monotonic", clock),
            patch.object(time, "thread_time", lambda: 0.0),
            patch.object(key_order, "idle_seconds", clock),
            patch.object(textual._time, "get_time", clock),
            patch.object(
                textual.timer, "sleep", asyncio.sleep
            ),  # Windows' own waits for a timer of the system, in a thread
            patch.object(selector, "select", select_or_move_on),
            patch.object(loop, "run_in_executor", run_at_once),
        ):
            yield clock
    finally:
        _clock = None
