"""All desktops of the class: starts them, finds them again, ends them."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import os
import socket
import sys
from collections.abc import Callable, Coroutine
from typing import Any

from day6_tui.core.isolation.cell import Limits
from day6_tui.core.isolation.mode import Mode
from day6_tui.tui.detached import meeting
from day6_tui.tui.web import starting
from day6_tui.tui.web.names import same_name
from day6_tui.tui.web.places import Places
from day6_tui.tui.web.session import Session
from day6_tui.tui.web.settings import Settings
from day6_tui.tui.web.viewer import Viewer

MOST_TABS = 4
"""Sockets of one pupil at a time; the oldest has to go."""


class Full(Exception):
    """There are as many desktops as there may be."""


class Sessions:
    """The desktops by the names of the pupils. Everything that blocks is done in threads."""

    def __init__(self, settings: Settings, places: Places, mode: Mode, tell: Callable[[str], None]) -> None:
        self._settings = settings
        self._places = places
        self._mode = mode
        self._tell = tell
        self.running: dict[str, Session] = {}
        self._locks: dict[str, asyncio.Lock] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    async def show(self, name: str, viewer: Viewer) -> Session:
        """Give the desktop of this pupil to a tab; it is started if it does not run. Raises Full, IsolationError, OSError."""
        key = same_name(name)
        async with self._locks.setdefault(key, asyncio.Lock()):
            session = self.running.get(key)
            if session is None:
                session = await self._open(name)
            connection = await self._connect(session)
            self._seat(session, viewer)
            session.greet(connection)
            return session

    def _seat(self, session: Session, viewer: Viewer) -> None:
        if viewer.read_only:
            session.watchers.append(viewer)
            return
        if session.writer is not None:
            session.writer.bye("taken")
        viewer.on_room = session.has_room
        session.writer = viewer

    async def leave(self, session: Session, viewer: Viewer) -> None:
        """A tab is gone. The desktop stays."""
        if viewer in session.watchers:
            session.watchers.remove(viewer)
        elif session.writer is viewer:
            session.writer = None
        if not session.is_watched:
            session.let_go()

    async def _open(self, name: str) -> Session:
        if len(self.running) >= self._settings.most:
            raise Full
        cell = await asyncio.to_thread(self._places.cell, name, self._mode, Limits())
        session = Session(name, cell, self._has_ended)
        self.running[same_name(name)] = session
        return session

    async def _connect(self, session: Session) -> socket.socket:
        """A line to the keeper, which is started if there is none."""
        if sys.platform == "win32":  # which has no keepers
            raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
        for _ in range(3):
            found = await asyncio.to_thread(meeting.connect, session.cell.home, self._places.keepers)
            if found is not None:
                return found
            with contextlib.suppress(BlockingIOError):  # one was just started, or is just ending
                return await asyncio.to_thread(
                    starting.start, self._mode, session.cell, self._places.keepers, self._words(session)
                )
            await asyncio.sleep(0.3)
        raise OSError("the desktop neither runs nor can be started")

    def _words(self, session: Session) -> list[str]:
        words = ["--home", str(session.cell.home), "--lang", self._settings.lang, *self._settings.words]
        if self._settings.lessons is not None:
            words += ["--lessons", str(self._settings.lessons)]
        return words

    def _has_ended(self, session: Session) -> None:
        self._later(self._sweep(session))

    def _later(self, coroutine: Coroutine[Any, Any, None]) -> None:
        task = asyncio.create_task(coroutine)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _sweep(self, session: Session) -> None:
        key = same_name(session.name)
        async with self._locks.setdefault(key, asyncio.Lock()):
            if self.running.get(key) is session:
                del self.running[key]
            await asyncio.to_thread(self._mode.end, session.cell)

    async def end_all(self, why: str) -> None:
        """End every desktop in order."""
        for session in list(self.running.values()):
            session.say_bye(why)
        await asyncio.gather(*(self._sweep(session) for session in list(self.running.values())))
