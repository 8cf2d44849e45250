"""Each key is worked off before the next one is handed on, however fast they come."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Awaitable, Callable, Iterator
from typing import Any

from textual import events
from textual.app import App
from textual.dom import DOMNode

PATIENCE = 1.0
"""Seconds after which a key that is still being worked off holds up no other one."""


class KeyOrder:
    """Hands on keys and pasted texts one by one.

    Textual gives each to what has the keyboard when it arrives, and that works it off later. Of a burst, the keys behind one that
    opens, closes or goes somewhere would so be taken by what had the keyboard before it. Here a mark follows each key on its
    way, from the widget up to the application; when it arrives, everything on the way has dealt with the key. A widget that
    says `LETTERS_STAY` does nothing with a letter that the next key could depend on: there none waits for a letter.
    """

    def __init__(self, app: App[Any], hand_over: Callable[[events.Event], Awaitable[None]]) -> None:
        self._app, self._hand_over = app, hand_over
        self._waiting: deque[events.Event] = deque()
        self._number = 0
        """Of the last key that was handed over."""
        self._since: float | None = None
        """When that was; None when it has been worked off."""

    async def take(self, event: events.Event) -> None:
        """Hand a key over now, or as soon as those before it are worked off."""
        self._waiting.append(event)
        if self._since is None or time.monotonic() - self._since > PATIENCE:
            await self._work_off()

    async def _work_off(self) -> None:
        while self._waiting:
            event = self._waiting.popleft()
            self._number, self._since = self._number + 1, time.monotonic()
            keyboard = self._app.focused or self._app.screen
            way = iter(keyboard.ancestors_with_self)
            await self._hand_over(event)
            if not (_is_letter(event) and getattr(keyboard, "LETTERS_STAY", False)):
                await self._follow(self._number, event, way)
                return
        self._since = None

    async def _follow(self, number: int, event: events.Event, way: Iterator[DOMNode]) -> None:
        """Wait behind key `number` in the queue of the next node on its way, up to the application."""
        if number != self._number:
            return  # it took too long
        for node in way:
            taken = _is_letter(event) and event._stop_propagation  # by the last node: it goes nowhere else
            if (node is self._app or not taken) and node.call_later(self._follow, number, event, way):
                return
        await self._work_off()


def _is_letter(event: events.Event) -> bool:
    return isinstance(event, events.Key) and event.is_printable
