"""All desktops of the class: starts them, finds them again, ends them. Everything that blocks is done in threads."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import math
import os
import socket
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TypeVar

from day6_core.classroom.homes import same_name
from day6_core.classroom.roster import PupilRow
from day6_core.isolation.cell import Cell, IsolationError, Phrase
from day6_core.isolation.mode import Mode
from day6_tui.detached import meeting
from day6_tui.locale import Texts
from day6_tui.web import starting
from day6_tui.web.background import Background, Report
from day6_tui.web.kept_sessions import KeptSessions
from day6_tui.web.names import TEACHERS
from day6_tui.web.nursery import Nursery
from day6_tui.web.places import Places
from day6_tui.web.pupil_files import PupilFiles
from day6_tui.web.records import Record
from day6_tui.web.roster_feed import RosterFeed
from day6_tui.web.session import WebSession
from day6_tui.web.settings import ServerSettings
from day6_tui.web.start_queue import StartQueue, at_once
from day6_tui.web.tokens import WATCHER
from day6_tui.web.viewer import Viewer

MOST_TABS = 4
"""Sockets of one pupil at a time; the oldest has to go."""

DOMAINS = range(1, 102)
"""For ROS_DOMAIN_ID; what really keeps the graphs apart is the runtime folder."""

WAITING_SECONDS = 30.0
"""After which somebody who found the class full counts as gone again."""

DRAW_SECONDS = 20.0
"""After which a desktop that has still drawn nothing keeps nobody else waiting."""

BACK_SECONDS = 30.0
"""For which the place of a desktop that starts again is kept: until its tab has come back."""

T = TypeVar("T")

Tell = Callable[..., None]
"""Prints a text of the catalogue: its key, and what fills it."""


class Full(Exception):
    """There are as many desktops as there may be."""


class Sessions:
    """The desktops by the names of the pupils."""

    def __init__(self, settings: ServerSettings, places: Places, mode: Mode, tell: Tell, failed: Report) -> None:
        self._settings = settings
        self._places = places
        self._mode = mode
        self._tell = tell
        self.folder = places.server
        """Where the server remembers things."""
        self._kept = KeptSessions(settings, places, mode, tell)
        self.running: dict[str, WebSession] = {}
        self._starting: dict[str, int] = {}
        """Those that will run as soon as their pupils' cells are there, and their domains."""
        self._addresses: dict[str, str] = {}
        """Where each pupil's browser is."""
        self.reserved: list[str] = []
        """Pupils who find a place whenever they come, however many others have come."""
        self.feed = RosterFeed(None if settings.proxied else places.log, tell)
        """What the teacher is told."""
        self.files = PupilFiles(mode, self._cell)
        self._tabs: dict[str, list[Viewer]] = {}
        self.came: Callable[[str, Viewer], None] = lambda name, viewer: None
        """Called for each new tab that types, and its pupil."""
        self._waiting: dict[str, float] = {}
        """Who found the class full, and when."""
        self._coming_back: dict[str, float] = {}
        """Whose desktops start again, and until when their places are kept for that."""
        self._apart: set[str] = set()
        """Whose desktops have been ended because something is done in between."""
        self._locks: dict[str, asyncio.Lock] = {}
        self._queue = StartQueue(at_once(), self._tell_place)
        self.nursery: Nursery | None = None
        """Where desktops are born; None: each is started singly."""
        self.background = Background(failed)
        self._is_closing = False

    @property
    def settings(self) -> ServerSettings:
        return self._settings

    @property
    def places(self) -> Places:
        return self._places

    @property
    def mode(self) -> Mode:
        """How pupils are kept apart."""
        return self._mode

    # -- tabs ----------------------------------------------------------------------------------------------------------

    async def show(self, name: str, viewer: Viewer) -> WebSession | None:
        """Give the desktop of this pupil to a tab, and start it if it does not run; None if the tab has to go meanwhile.

        Raises Full, IsolationError, OSError.
        """
        key = same_name(name)
        tabs = self._tabs.setdefault(key, [])
        tabs.append(viewer)
        for oldest in tabs[:-MOST_TABS]:
            oldest.bye("taken")
            tabs.remove(oldest)
        if (before := 0 if key in self._apart else self._queue.before(key)) is not None:
            viewer.expect(before)
        async with self._lock(key):
            try:
                session = None if viewer.is_over or self._is_closing else await self._seated(name, viewer)
            finally:
                if viewer.session is None:
                    await self._pass_on(key, viewer)
            if session is not None:
                await self._observe(session)
                self.feed.seen(session.name, bool(session.watchers))
            return session

    async def _seated(self, name: str, viewer: Viewer) -> WebSession | None:
        """The desktop, which draws for this tab now; None if the tab had to go. Raises Full, IsolationError, OSError."""
        session = self.running.get(same_name(name))
        if session is not None and session.is_over:
            await self._clear(session)
            session = None
        if session is None:
            session = await self._new(name)
        try:
            connection = await self._connect(session, viewer)
        except (IsolationError, OSError):
            await self._clear(session)
            raise
        if connection is None:
            return None
        if viewer.is_over:
            connection.close()
            return None
        _seat(session, viewer)
        if not viewer.read_only:
            self.came(session.name, viewer)
        session.greet(connection)
        self._wait_until_drawn(session)
        if session.writer is viewer and viewer.early:
            session.type(bytes(viewer.early))
        return session

    async def leave(self, name: str, viewer: Viewer) -> None:
        """A tab is gone. The desktop stays."""
        key = same_name(name)
        if viewer in (tabs := self._tabs.get(key, [])):
            tabs.remove(viewer)
        if not tabs:
            self._tabs.pop(key, None)
        session = self.running.get(key)
        if session is None:
            return
        if viewer in session.watchers:
            session.watchers.remove(viewer)
            self.feed.seen(session.name, bool(session.watchers))
        elif session.writer is viewer:
            session.writer = None
        if session.is_watched:
            session.has_room()  # those who only watch keep nobody waiting
        else:
            session.let_go()
        self.feed.tell()

    # -- the queue -----------------------------------------------------------------------------------------------------

    def _tell_place(self, key: str, before: int) -> None:
        for viewer in self._tabs.get(key, []):
            viewer.expect(before)

    def _wait_until_drawn(self, session: WebSession) -> None:
        """Let the next desktop start when this one has begun to draw."""
        key = same_name(session.name)
        if self._queue.before(key) is None:
            return
        late = asyncio.get_running_loop().call_later(DRAW_SECONDS, self._queue.done, key)

        def drawn() -> None:
            late.cancel()
            self._queue.done(key)

        session.on_drawn = drawn

    async def _pass_on(self, key: str, viewer: Viewer) -> None:
        """A tab got no desktop in its turn: another of the pupil's has it or takes it, or else the next pupil does."""
        others = (tab for tab in self._tabs.get(key, []) if tab is not viewer)
        if self._queue.before(key) == 0 and all(tab.is_over for tab in others):
            self._queue.done(key)
            if (session := self.running.get(key)) is not None:
                await self._clear(session)

    def typing_tabs(self) -> Iterator[tuple[str, Viewer]]:
        """The tabs that show a desktop and type into it, and whose it is."""
        for session in self.running.values():
            if session.writer is not None:
                yield session.name, session.writer

    # -- one desktop ---------------------------------------------------------------------------------------------------

    def _lock(self, key: str) -> asyncio.Lock:
        return self._locks.setdefault(key, asyncio.Lock())

    async def _new(self, name: str) -> WebSession:
        key = same_name(name)
        if not self._has_place(key):
            self._turn_away(name)
            raise Full
        domain = self._starting[key] = self._free_domain()  # before anything is awaited: others come meanwhile
        try:
            session = await self._session(name, domain)
            if self._is_closing:
                raise Full
            self.running[key] = session
        finally:
            del self._starting[key]
        self._waiting.pop(key, None)
        self._coming_back.pop(key, None)
        await self._kept.write(self.running.values())
        return session

    def _has_place(self, key: str) -> bool:
        """Whether there is room, also for those who have a place and do not use it now."""
        if key == TEACHERS:
            return True
        used = {*self.running, *self._starting} - {TEACHERS}
        back = {each for each, until in self._coming_back.items() if time.monotonic() < until}
        kept = {*map(same_name, self.reserved), *back} - used
        return len(used) + (0 if key in kept else len(kept)) < self._settings.most

    def _turn_away(self, name: str) -> None:
        if not self.waits(name):
            running, most = len(self.running.keys() - {TEACHERS}), self._settings.most
            self._tell("serve.full" if running >= most else "serve.full.kept", name=name, most=most, running=running)
        self._waiting[same_name(name)] = time.monotonic()
        self.feed.roster.expect([name])
        self.feed.tell()

    def waits(self, name: str) -> bool:
        """Whether the pupil has lately found the class full; the page tries again by itself."""
        return time.monotonic() - self._waiting.get(same_name(name), -math.inf) < WAITING_SECONDS

    def _free_domain(self) -> int:
        if self._settings.proxied:
            return self._settings.domain
        used = {*(session.domain for session in self.running.values()), *self._starting.values()}
        return next((number for number in DOMAINS if number not in used), DOMAINS[0])

    async def _session(self, name: str, domain: int) -> WebSession:
        return WebSession(name, await asyncio.to_thread(self._cell, name), domain, self._has_ended)

    def _cell(self, name: str) -> Cell:
        settings = self._settings
        if settings.proxied:
            return self._places.own_cell(self._mode, settings.limits, settings.home)
        return self._places.cell(name, self._mode, settings.limits)

    async def _connect(self, session: WebSession, viewer: Viewer) -> socket.socket | None:
        """A line to the keeper, which is started if there is none, in its turn; None if the tab has gone before."""
        for _ in range(3):
            found = await asyncio.to_thread(self._found, session.cell.home)
            if found is not None:
                return found
            if not await self._queue.turn(same_name(session.name)) or viewer.is_over:
                return None
            with contextlib.suppress(BlockingIOError):  # one was just started, or is just ending
                return await asyncio.to_thread(
                    starting.start,
                    self._mode,
                    session.cell,
                    self._places.keepers,
                    session.domain,
                    self._words(viewer.lang),
                    self.nursery,
                )
            await asyncio.sleep(0.3)
        raise OSError(errno.EAGAIN, os.strerror(errno.EAGAIN))

    async def _observe(self, session: WebSession) -> None:
        """Let the teacher hear of the desktop; without that it runs as well."""
        if not session.is_observed:
            with contextlib.suppress(OSError):
                found = await asyncio.to_thread(self._found, session.cell.home)
                if found is not None:
                    session.is_observed = True
                    self.feed.begin(session.name, found)
        self.feed.tell()

    def note_address(self, name: str, address: str) -> None:
        """A pupil comes from there."""
        self._addresses[same_name(name)] = address

    def address_of(self, name: str) -> str:
        """Where the pupil's browser is or was; "" if it has not come to this server."""
        return self._addresses.get(same_name(name), "")

    def has_tab(self, name: str) -> bool:
        """Whether the pupil's desktop is open in a browser."""
        session = self.running.get(same_name(name))
        return session is not None and session.writer is not None

    def state_of(self, row: PupilRow) -> str:
        """What the teacher sees of a pupil: here, away (without a tab), full (who found no room), gone, absent."""
        if row.is_here:
            return "here" if self.has_tab(row.name) else "away"
        return "full" if self.waits(row.name) else "gone" if row.has_come else "absent"

    def words(self, phrase: Phrase) -> str:
        """A text of the catalogue in the language of the server."""
        return Texts(self._settings.lang)(phrase.key, **phrase.values)

    def _found(self, home: Path) -> socket.socket | None:
        if sys.platform == "win32":  # which has no keepers
            raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
        return meeting.connect(home, self._places.keepers)

    def _words(self, lang: str) -> list[str]:
        words = ["--lang", self._settings.desktop_lang or lang]
        return words if self._settings.lessons is None else [*words, "--lessons", str(self._settings.lessons)]

    def _has_ended(self, session: WebSession) -> None:
        """The keeper said so, or it is gone."""
        self.background.begin("serve.failed.end", self._sweep(session))

    def stop_watching(self) -> None:
        """No new desktop begins, and nothing is looked at any more."""
        self._is_closing = True
        self._queue.close()
        for tabs in self._tabs.values():
            for viewer in tabs:
                viewer.bye("server")
        self.background.close()

    async def _sweep(self, session: WebSession) -> None:
        async with self._lock(same_name(session.name)):
            if self.running.get(same_name(session.name)) is session:
                await self._clear(session)

    async def _clear(self, session: WebSession) -> bool:
        """Leave nothing of it but the files; return whether that could be done."""
        session.is_over = True
        session.let_go()
        self._queue.done(same_name(session.name))
        self.feed.end(session.name)
        has_ended = await asyncio.to_thread(starting.stop, self._mode, session.cell, self._places.keepers)
        if not has_ended:
            self._tell("serve.left", name=session.name)
        self.running.pop(same_name(session.name), None)
        await self._kept.write(self.running.values())
        return has_ended

    async def end(self, session: WebSession, why: str) -> None:
        """End a desktop and tell its tabs why."""
        session.is_over = True
        session.say_bye(why)
        await self._sweep(session)

    async def apart(self, name: str, work: Callable[[Cell], T]) -> T:
        """End the pupil's desktop, do this in a thread, and let the tabs come back only then: the desktop starts again by that.

        Raises OSError if something of the desktop cannot be ended, IsolationError, and what `work` raises.
        """
        key = same_name(name)
        async with self._lock(key):  # one that is just being started is there then
            self._apart.add(key)
            try:
                session = self.running.get(key)
                if session is not None:
                    if session.writer is not None:
                        self._coming_back[key] = time.monotonic() + BACK_SECONDS
                    session.say_bye("restart")
                    if not await self._clear(session):
                        raise OSError(errno.EBUSY, os.strerror(errno.EBUSY))
                cell = await asyncio.to_thread(self._cell, name) if session is None else session.cell
                return await asyncio.to_thread(work, cell)
            finally:
                self._apart.discard(key)

    def home_of(self, name: str) -> Path:
        """Where the pupil's home is, or will be."""
        return self._places.home(name)

    async def remove(self, name: str) -> None:
        """End the pupil's desktop, if it runs, and close all tabs."""
        self.turn_out(name, "removed")
        self._queue.drop(same_name(name))
        async with self._lock(same_name(name)):  # one that is just being started is there then
            session = self.running.get(same_name(name))
        if session is not None:
            await self.end(session, "removed")

    def turn_out(self, name: str, why: str, *, kind: str | None = None) -> None:
        """Close the tabs of a pupil, or only those that came by a link of this kind."""
        for viewer in self._tabs.get(same_name(name), []):
            if kind is None or viewer.read_only == (kind == WATCHER):
                viewer.bye(why)

    async def end_all(self) -> None:
        """End every desktop in order; no new one begins."""
        self.stop_watching()
        await asyncio.gather(*(self.end(session, "server") for session in list(self.running.values())))

    def say_bye(self) -> None:
        """To all tabs; the desktops go on."""
        self.stop_watching()
        for session in self.running.values():
            session.say_bye("server")

    # -- what is remembered --------------------------------------------------------------------------------------------

    async def find_again(self, names: Iterable[str]) -> int:
        """Take over the desktops of a server that was killed, end what cannot be; return how many go on. Raises OSError.

        Those of the pupils in `names` are found although they are not recorded, as after a full disk.
        """
        found = await self._kept.read()
        await asyncio.gather(*map(self._find, found))
        recorded = {same_name(record.name) for record in found}
        for name in names:
            if same_name(name) not in recorded:
                await self._find_unrecorded(name)
        await self._kept.write(self.running.values())
        return len(self.running)

    async def _find(self, record: Record) -> None:
        try:
            if record.mode != self._mode.name:
                await self._kept.end_other(record)
                return
            session = await self._session(record.name, record.domain)
            probe = await asyncio.to_thread(self._found, session.cell.home)
            if probe is None:
                await asyncio.to_thread(starting.stop, self._mode, session.cell, self._places.keepers)
                return
            self._take_over(session, probe)
        except (IsolationError, OSError):
            self._tell("serve.left", name=record.name)

    async def _find_unrecorded(self, name: str) -> None:
        try:
            home = (
                (await asyncio.to_thread(self._cell, name)).home if self._settings.proxied else self._places.home(name)
            )
            probe = await asyncio.to_thread(self._found, home)
            if probe is not None:
                self._take_over(await self._session(name, self._free_domain()), probe)
        except (IsolationError, OSError):
            self._tell("serve.left", name=name)

    def _take_over(self, session: WebSession, connection: socket.socket) -> None:
        self.running[same_name(session.name)] = session
        session.is_observed = True
        self.feed.begin(session.name, connection)


def _seat(session: WebSession, viewer: Viewer) -> None:
    """Show the desktop to this tab; one that types takes it over."""
    viewer.session = session
    if viewer.read_only:
        session.watchers.append(viewer)
        return
    if session.writer is not None:
        session.writer.bye("taken")
    viewer.on_room = session.has_room
    session.writer = viewer
    session.typed_at = time.monotonic()
