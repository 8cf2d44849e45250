"""Desktops start a few at a time: whoever comes first soon has one, and everybody else is told how many come before.

All at once would finish at the same moment, the last one: thirty desktops share the processors then, and nobody sees anything.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from day6_core.system.memory import processors


def at_once() -> int:
    """Return how many desktops start at the same time: one for each processor that this server may use."""
    return processors()


class StartQueue:
    """Who starts and who waits, by a key for each pupil. `tell(key, before)` is called whenever the number changes."""

    def __init__(self, most: int, tell: Callable[[str, int], None]) -> None:
        self._most = most
        self._tell = tell
        self._starting: set[str] = set()
        self._waiting: dict[str, asyncio.Event] = {}
        """In the order in which they came; whoever loads the page anew keeps the place."""
        self._is_closed = False

    def before(self, key: str) -> int | None:
        """Return how many have to get their desktops before; 0 while it starts, None if it does not wait."""
        if key in self._starting:
            return 0
        return len(self._starting) + list(self._waiting).index(key) if key in self._waiting else None

    async def turn(self, key: str) -> bool:
        """Wait until this one may start; False if it never may. `done` has to be called afterwards. One waits for a key."""
        if key not in self._starting and not self._is_closed:
            comes = self._waiting.setdefault(key, asyncio.Event())
            self._tell(key, self.before(key) or 0)
            self._go_on()
            await comes.wait()
        return key in self._starting

    def done(self, key: str) -> None:
        """It has started, or never will."""
        if key in self._starting:
            self._starting.remove(key)
            self._go_on()

    def drop(self, key: str) -> None:
        """Let it wait no longer."""
        if (comes := self._waiting.pop(key, None)) is not None:
            comes.set()
            self._tell_all()

    def close(self) -> None:
        """Nobody's turn comes any more."""
        self._is_closed = True
        while self._waiting:
            self._waiting.popitem()[1].set()

    def _go_on(self) -> None:
        if not self._waiting or len(self._starting) >= self._most:
            return
        while self._waiting and len(self._starting) < self._most:
            key = next(iter(self._waiting))
            self._waiting.pop(key).set()
            self._starting.add(key)
            self._tell(key, 0)
        self._tell_all()

    def _tell_all(self) -> None:
        for number, key in enumerate(self._waiting, len(self._starting)):
            self._tell(key, number)
