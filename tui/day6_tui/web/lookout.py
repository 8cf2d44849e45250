"""Looks now and then at every desktop: whether anybody types, and whether the home has become too large."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable

from day6_core.classroom.order import Order
from day6_tui.locale import Texts
from day6_tui.web.session import WebSession
from day6_tui.web.sessions import Sessions

LOOK_SECONDS = 30.0
"""Between two looks at what each desktop takes of the disk, and whether somebody types."""

DISK_PATIENCE = 1.5
"""A home that is so many times as large as it may be ends its desktop; before that the teacher is told."""


class Lookout:
    """Ends what is idle or takes too much. `tell` prints a text of the catalogue."""

    def __init__(self, sessions: Sessions, tell: Callable[..., None]) -> None:
        self._sessions = sessions
        self._settings = sessions.settings
        self._tell = tell

    def watch(self) -> None:
        """Watch the idle and the disk, for as long as the server runs."""
        seconds = min(LOOK_SECONDS, max(1.0, self._settings.idle * 15)) if self._settings.idle else LOOK_SECONDS
        self._sessions.background.repeat("serve.failed.look", seconds, self.look)

    async def look(self) -> None:
        """Look at all desktops once; where that fails for one, it does not for the others."""
        for session in list(self._sessions.running.values()):
            if not session.is_over:
                await self._sessions.background.heard("serve.failed.look", self._look_at(session))

    async def _look_at(self, session: WebSession) -> None:
        if self._is_idle(session):
            self._tell("serve.idle", name=session.name, minutes=f"{self._settings.idle:g}")
            await self._sessions.end(session, "idle")
        else:
            await self._look_at_disk(session)

    def _is_idle(self, session: WebSession) -> bool:
        return 0 < self._settings.idle * 60 <= time.monotonic() - session.typed_at

    async def _look_at_disk(self, session: WebSession) -> None:
        used = await asyncio.to_thread(self._sessions.mode.disk_used, session.cell)
        most = session.cell.limits.disk
        was_over, session.is_over_disk = session.is_over_disk, used > most
        if not session.is_over_disk:
            return
        values = {"name": session.name, "used": used >> 20, "most": most >> 20}
        if used > DISK_PATIENCE * most:
            self._tell("serve.disk.ended", **values)
            await self._sessions.end(session, "disk")
        elif not was_over:
            self._tell("serve.disk.over", **values)
            text = Texts(self._settings.lang)("serve.disk.say", used=values["used"], most=values["most"])
            self._sessions.feed.send(session.name, Order("say", text=text))
