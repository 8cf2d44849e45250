"""Each key is worked off before the next one is handed on, however fast they come."""

from __future__ import annotations

from collections import deque
from collections.abc import Awaitable, Callable, Iterator
from typing import Protocol, runtime_checkable

from textual import events
from textual.dom import DOMNode
from textual.widget import Widget

from day6_core.session.cores import idle_seconds

PATIENCE = 1.0
"""Idle seconds after which a key that is still being worked off holds up no other one: it is stuck, and not just slow."""


@runtime_checkable
class KeepsKeyboard(Protocol):
    """A widget in which most keys change nothing but a text."""

    def keeps_keyboard(self, event: events.Event) -> bool:
        """Whether what comes behind this key goes to this widget too, whatever becomes of the key."""


def is_letter(event: events.Event) -> bool:
    """Whether it is a key that writes something."""
    return isinstance(event, events.Key) and event.is_printable


class KeyOrder:
    """Hands on keys and pasted texts one by one.

    Textual gives each to what has the keyboard when it arrives, and that works it off later. Of a burst, the keys behind one that
    opens, closes or goes somewhere would so be taken by what had the keyboard before it. Here a mark follows each key on its
    way, from the widget up to the application; when it arrives, everything on the way has dealt with the key. Nothing waits for
    a key of which the widget says that it keeps the keyboard.
    """

    def __init__(self, keyboard: Callable[[], Widget], hand_over: Callable[[events.Event], Awaitable[None]]) -> None:
        """`keyboard` returns the widget that has the keyboard, `hand_over` lets the application give a key to it."""
        self._keyboard, self._hand_over = keyboard, hand_over
        self._waiting: deque[events.Event] = deque()
        self._number = 0
        """Of the last key that was handed over."""
        self._since: float | None = None
        """When that was, by `idle_seconds`; None when it has been worked off."""

    async def take(self, event: events.Event) -> None:
        """Hand a key over now, or as soon as those before it are worked off."""
        self._waiting.append(event)
        if self._since is None or idle_seconds() - self._since > PATIENCE:
            await self._work_off()

    async def _work_off(self) -> None:
        while self._waiting:
            event = self._waiting.popleft()
            self._number, self._since = self._number + 1, idle_seconds()
            keyboard = self._keyboard()
            # Twice at each node: what it posts because of the key comes behind the mark.
            way = iter([node for node in keyboard.ancestors_with_self for _ in range(2)])
            await self._hand_over(event)
            if not (isinstance(keyboard, KeepsKeyboard) and keyboard.keeps_keyboard(event)):
                await self._follow(self._number, way)
                return
        self._since = None

    async def _follow(self, number: int, way: Iterator[DOMNode]) -> None:
        """Wait behind key `number` in the queue of the next node on its way, up to the application."""
        if number != self._number:
            return  # it took too long
        for node in way:
            if node.call_later(self._follow, number, way):
                return
        await self._work_off()
