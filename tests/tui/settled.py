"""Waits until an application under test has nothing left to do, instead of until the processor looks idle.

Textual's own way sleeps at least 20 ms a time and asks how busy the process was: three quarters of these tests' time, and on a
loaded machine no answer. What is to be done stands in the queues of the widgets; when they are empty, nothing happens any more
until a frame is stepped, a key comes or a timer is due.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Iterator

import textual.app
import textual.pilot
from textual._context import active_app
from textual.message_pump import MessagePump
from textual.screen import Screen

ROUNDS = 3
"""Turns of the event loop in a row without anything to do: what one handler awaits may take one."""
NAP = 0.0005


async def wait_until_settled(min_sleep: float = 0, max_sleep: float = 1) -> None:
    """Do what `textual._wait.wait_for_idle` is for; at most `max_sleep` seconds."""
    app = active_app.get()
    end = time.monotonic() + max_sleep
    quiet = 0
    while quiet < ROUNDS and time.monotonic() < end:
        await asyncio.sleep(0 if quiet else NAP)
        busy = False
        for pump in _pumps(app):
            busy = busy or bool(pump._message_queue.qsize() or pump._next_callbacks)
        if not busy and app._resize_event is not None:
            app._check_resize()  # a timer would, up to 8 ms later
            busy = True
        for screen in app.screen_stack:
            if not busy and _is_dirty(screen):
                screen._on_timer_update()  # the same
                busy = True
        quiet = 0 if busy else quiet + 1


def _is_dirty(screen: Screen[object]) -> bool:
    return bool(screen._layout_required or screen._scroll_required or screen._repaint_required or screen._dirty_widgets)


def _pumps(app: textual.app.App[None]) -> Iterator[MessagePump]:
    yield app
    for screen in app.screen_stack:
        yield from (each for each in screen.walk_children(with_self=True) if each._running)


def install() -> None:
    """Let Textual's pilot wait like this."""
    textual.app.wait_for_idle = textual.pilot.wait_for_idle = wait_until_settled  # type: ignore[attr-defined]
