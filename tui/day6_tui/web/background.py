"""Work that nobody awaits. What fails in it is reported, and everything else goes on: nothing dies unheard."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Coroutine
from typing import Any

from day6_core.reason import fault

Report = Callable[[str, Exception], None]
"""Told what failed (the key of a text) and why."""


class Background:
    """Tasks of the event loop, for as long as the server runs."""

    def __init__(self, report: Report) -> None:
        self._report = report
        self._tasks: set[asyncio.Task[None]] = set()
        self._repeated: list[asyncio.Task[None]] = []
        self._last: dict[str, str] = {}
        """What was reported last of each work: the same again and again is no news."""

    def begin(self, what: str, work: Coroutine[Any, Any, None]) -> asyncio.Task[None]:
        """Start this; it never raises."""
        task = asyncio.create_task(self.heard(what, work))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return task

    def repeat(self, what: str, seconds: float, work: Callable[[], Awaitable[None]]) -> None:
        """Do this again and again, also after it has failed."""

        async def again() -> None:
            while True:
                await asyncio.sleep(seconds)
                await self.heard(what, work())

        self._repeated.append(self.begin(what, again()))

    async def heard(self, what: str, work: Awaitable[None]) -> None:
        """Wait for this; report it if it fails."""
        try:
            await work
        except Exception as error:
            reason = fault(error)
            if self._last.get(what) != reason:
                self._last[what] = reason
                self._report(what, error)

    def close(self) -> None:
        """Repeat nothing any more; what has begun is finished."""
        for task in self._repeated:
            task.cancel()
