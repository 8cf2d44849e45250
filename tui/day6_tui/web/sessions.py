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
from collections.abc import Callable, Iterable
from pathlib import Path

from day6_core.classroom.order import Order
from day6_core.classroom.roster import PupilRow
from day6_core.isolation.cell import Cell, IsolationError
from day6_core.isolation.mode import Mode
from day6_core.isolation.modes import survey
from day6_core.reason import reason
from day6_tui.detached import meeting
from day6_tui.locale import Texts
from day6_tui.web import records, starting
from day6_tui.web.background import Background, Report
from day6_tui.web.names import same_name
from day6_tui.web.places import Places
from day6_tui.web.records import Record
from day6_tui.web.roster_feed import RosterFeed
from day6_tui.web.session import WebSession
from day6_tui.web.settings import ServerSettings
from day6_tui.web.tokens import WATCHER
from day6_tui.web.viewer import Viewer

MOST_TABS = 4
"""Sockets of one pupil at a time; the oldest has to go."""

LOOK_SECONDS = 30.0
"""Between two looks at what each desktop takes of the disk, and whether somebody types."""

DISK_PATIENCE = 1.5
"""A home that is so many times as large as it may be ends its desktop; before that the teacher is told."""

DOMAINS = range(1, 102)
"""For ROS_DOMAIN_ID; what really keeps the graphs apart is the runtime folder."""

WAITING_SECONDS = 30.0
"""After which somebody who found the class full counts as gone again."""

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
        self._file = places.server / "sessions.json"
        self.running: dict[str, WebSession] = {}
        self._starting: dict[str, int] = {}
        """Those that will run as soon as their pupils' cells are there, and their domains."""
        self._addresses: dict[str, str] = {}
        """Where each pupil's browser is."""
        self.reserved: list[str] = []
        """Pupils who find a place whenever they come, however many others have come."""
        self.feed = RosterFeed()
        """What the teacher is told."""
        self._tabs: dict[str, list[Viewer]] = {}
        self._waiting: dict[str, float] = {}
        """Who found the class full, and when."""
        self._locks: dict[str, asyncio.Lock] = {}
        self.background = Background(failed)
        self._writing = asyncio.Lock()
        self._is_closing = False

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
        async with self._lock(key):
            if viewer.is_over or self._is_closing:
                return None
            session = self.running.get(key)
            if session is not None and session.is_over:
                await self._clear(session)
                session = None
            if session is None:
                session = await self._new(name)
            try:
                connection = await self._connect(session)
            except (IsolationError, OSError):
                await self._clear(session)
                raise
            if viewer.is_over:
                connection.close()
                return None
            _seat(session, viewer)
            session.greet(connection)
            await self._observe(session)
            self.feed.seen(session.name, bool(session.watchers))
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
        await self._remember()
        return session

    def _has_place(self, key: str) -> bool:
        """Whether there is room, also for those who have a place and do not use it now."""
        used = {*self.running, *self._starting}
        kept = {same_name(name) for name in self.reserved} - used
        return len(used) + (0 if key in kept else len(kept)) < self._settings.most

    def _turn_away(self, name: str) -> None:
        if not self.waits(name):
            running, most = len(self.running), self._settings.most
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

    async def _connect(self, session: WebSession) -> socket.socket:
        """A line to the keeper, which is started if there is none."""
        for _ in range(3):
            found = await asyncio.to_thread(self._found, session.cell.home)
            if found is not None:
                return found
            with contextlib.suppress(BlockingIOError):  # one was just started, or is just ending
                return await asyncio.to_thread(
                    starting.start, self._mode, session.cell, self._places.keepers, session.domain, self._words()
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

    def state_of(self, row: PupilRow) -> str:
        """What the teacher sees of a pupil: here, away (without a tab), full (who found no room), gone, absent."""
        session = self.running.get(same_name(row.name))
        if row.is_here:
            return "here" if session is not None and session.writer is not None else "away"
        return "full" if self.waits(row.name) else "gone" if row.has_come else "absent"

    def _found(self, home: Path) -> socket.socket | None:
        if sys.platform == "win32":  # which has no keepers
            raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
        return meeting.connect(home, self._places.keepers)

    def _words(self) -> list[str]:
        words = ["--lang", self._settings.lang]
        return words if self._settings.lessons is None else [*words, "--lessons", str(self._settings.lessons)]

    def _has_ended(self, session: WebSession) -> None:
        """The keeper said so, or it is gone."""
        self.background.begin("serve.failed.end", self._sweep(session))

    def stop_watching(self) -> None:
        """No new desktop begins, and nothing is looked at any more."""
        self._is_closing = True
        self.background.close()

    async def _sweep(self, session: WebSession) -> None:
        async with self._lock(same_name(session.name)):
            if self.running.get(same_name(session.name)) is session:
                await self._clear(session)

    async def _clear(self, session: WebSession) -> None:
        """Leave nothing of it but the files."""
        session.is_over = True
        session.let_go()
        self.feed.end(session.name)
        if not await asyncio.to_thread(starting.stop, self._mode, session.cell, self._places.keepers):
            self._tell("serve.left", name=session.name)
        self.running.pop(same_name(session.name), None)
        await self._remember()

    async def end(self, session: WebSession, why: str) -> None:
        """End a desktop and tell its tabs why."""
        session.is_over = True
        session.say_bye(why)
        await self._sweep(session)

    async def remove(self, name: str) -> None:
        """End the pupil's desktop, if it runs, and close all tabs."""
        self.turn_out(name, "removed")
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

    async def _remember(self) -> None:
        async with self._writing:  # or an older list might be written last
            found = [Record(each.name, self._mode.name, each.domain) for each in self.running.values()]
            try:
                await asyncio.to_thread(records.write, self._file, found)
            except OSError as error:  # a full disk: the class goes on
                self._tell("serve.no_record", file=str(self._file), reason=reason(error))

    async def find_again(self, names: Iterable[str]) -> int:
        """Take over the desktops of a server that was killed, end what cannot be; return how many go on. Raises OSError.

        Those of the pupils in `names` are found although they are not recorded, as after a full disk.
        """
        try:
            found = await asyncio.to_thread(records.read, self._file)
        except ValueError:
            self._tell("serve.bad_record", file=str(self._file))
            found = []
        await asyncio.gather(*map(self._find, found))
        recorded = {same_name(record.name) for record in found}
        for name in names:
            if same_name(name) not in recorded:
                await self._find_unrecorded(name)
        await self._remember()
        return len(self.running)

    async def _find(self, record: Record) -> None:
        try:
            if record.mode != self._mode.name:
                await self._end_other(record)
                return
            session = await self._session(record.name, record.domain)
            probe = await asyncio.to_thread(self._found, session.cell.home)
            if probe is None:
                await asyncio.to_thread(starting.stop, self._mode, session.cell, self._places.keepers)
                return
            self._take_over(session, probe)
        except (IsolationError, OSError):
            self._tell("serve.left", name=record.name)

    async def _end_other(self, record: Record) -> None:
        """A desktop of a server that kept pupils apart in another way: it cannot go on. Raises IsolationError, OSError."""
        (offer,) = await asyncio.to_thread(survey, (record.mode,))
        if offer.mode is None:
            self._tell("serve.left", name=record.name)
            return
        places = Places(self._settings.data, offer.mode)
        cell = await asyncio.to_thread(places.cell, record.name, offer.mode, self._settings.limits)
        gone = await asyncio.to_thread(starting.stop, offer.mode, cell, places.keepers)
        self._tell("serve.other_mode" if gone else "serve.left", name=record.name, mode=record.mode)

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

    # -- what is looked at now and then --------------------------------------------------------------------------------

    def watch(self) -> None:
        """Watch the idle and the disk, for as long as the server runs."""
        seconds = min(LOOK_SECONDS, max(1.0, self._settings.idle * 15)) if self._settings.idle else LOOK_SECONDS
        self.background.repeat("serve.failed.look", seconds, self.look)

    async def look(self) -> None:
        """Look at all desktops once; where that fails for one, it does not for the others."""
        for session in list(self.running.values()):
            if not session.is_over:
                await self.background.heard("serve.failed.look", self._look_at(session))

    async def _look_at(self, session: WebSession) -> None:
        if self._is_idle(session):
            self._tell("serve.idle", name=session.name, minutes=f"{self._settings.idle:g}")
            await self.end(session, "idle")
        else:
            await self._look_at_disk(session)

    def _is_idle(self, session: WebSession) -> bool:
        return 0 < self._settings.idle * 60 <= time.monotonic() - session.typed_at

    async def _look_at_disk(self, session: WebSession) -> None:
        used = await asyncio.to_thread(self._mode.disk_used, session.cell)
        most = session.cell.limits.disk
        was_over, session.is_over_disk = session.is_over_disk, used > most
        if not session.is_over_disk:
            return
        values = {"name": session.name, "used": used >> 20, "most": most >> 20}
        if used > DISK_PATIENCE * most:
            self._tell("serve.disk.ended", **values)
            await self.end(session, "disk")
        elif not was_over:
            self._tell("serve.disk.over", **values)
            text = Texts(self._settings.lang)("serve.disk.say", used=values["used"], most=values["most"])
            self.feed.send(session.name, Order("say", text=text))


def _seat(session: WebSession, viewer: Viewer) -> None:
    """Show the desktop to this tab; one that types takes it over."""
    if viewer.read_only:
        session.watchers.append(viewer)
        return
    if session.writer is not None:
        session.writer.bye("taken")
    viewer.on_room = session.has_room
    session.writer = viewer
    session.typed_at = time.monotonic()
