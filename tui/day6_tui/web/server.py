"""The server: its parts, in the order in which they begin and end."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import os
import socket
import ssl
import stat
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from aiohttp import web

from day6_core.classroom.homes import TOKENS
from day6_core.isolation import machine
from day6_core.isolation.cell import Cell, IsolationError, Phrase
from day6_core.isolation.modes import ModeOffer
from day6_core.link.addresses import own_address
from day6_core.link.file_lock import FileLock
from day6_core.link.kept_files import USED_SECONDS
from day6_core.reason import fault, reason
from day6_core.system import memory
from day6_tui.web import class_list, connections, room, starting
from day6_tui.web.application import Application
from day6_tui.web.entrance import Entrance
from day6_tui.web.links import Links
from day6_tui.web.lobby import Lobby
from day6_tui.web.lookout import Lookout
from day6_tui.web.nursery import Nursery
from day6_tui.web.places import Places, login_name, own_home
from day6_tui.web.sessions import Sessions, Tell
from day6_tui.web.settings import ServerSettings
from day6_tui.web.tokens import PUPIL, TEACHER, Ticket, Tokens

CLOSE_SECONDS = 3.0
"""What open sockets get to say goodbye."""

LEAST_TO_SHARE = 3
"""Desktops, from which on it takes less memory to fork them from a common parent."""

ONLY_DESKTOP = "me"
"""The pupil where there is neither a list nor a word."""


class InUse(Exception):
    """Another server has this folder."""


class Server:
    """What `day6-tui serve` runs."""

    def __init__(self, settings: ServerSettings, offer: ModeOffer, tell: Tell) -> None:
        assert offer.mode is not None
        self._settings = settings
        self._tell = tell
        self._offer = offer
        self._mode = offer.mode
        self._places = Places(settings.data, offer.mode)
        self._lock = FileLock(self._places.server / "lock")
        self._runs = FileLock(self._places.lock)
        self._tokens = Tokens(self._places.server / TOKENS)
        self._sessions = Sessions(settings, self._places, offer.mode, tell, self._failed)
        self._runner: web.AppRunner | None = None

    def _failed(self, what: str, error: Exception) -> None:
        self._tell_all("serve.failed", what=Phrase(what), reason=fault(error))

    def _tell_all(self, key: str, **values: object) -> None:
        """Tell whoever has started the server, and the teacher."""
        self._tell(key, **values)
        self._sessions.feed.say(key, **values)

    async def open(self) -> None:
        """Begin to serve, and say where. Raises IsolationError, OSError, InUse, BadTokens, BadList."""
        self._places.make()
        if (closed := self._mode.closed_before((self._places.homes, self._places.runtimes))) is not None:
            raise IsolationError("isolation.no.closed", folder=str(closed))
        if not self._lock.try_acquire():
            raise InUse(str(self._settings.data))
        self._runs.try_acquire()
        self._tokens.load()
        names = self._names()
        listener = self._listener()
        secure = self._secure()
        base = self._address(listener, secure is not None)
        links = Links(self._tokens, base)
        new = links.enrol(names, anew=self._settings.new_links)
        teacher = None if self._settings.proxied else links.make(Ticket(TEACHER))
        await links.keep()
        self._sessions.feed.roster.journal.note("began")
        self._sessions.feed.roster.expect(names)
        self._sessions.reserved = names
        again = await self._sessions.find_again([login_name()] if self._settings.proxied else links.all_names())
        await asyncio.to_thread(self._places.remember)
        lessons = await asyncio.to_thread(_lessons, self._settings.lessons)
        what = self._offer.what_it_is
        kept = self._sessions.feed.kept(self._places.server / "addresses.json")
        lobby = Lobby(self._settings.unasked, None if self._settings.proxied else kept)
        entrance = Entrance(self._tokens, links, self._sessions, lobby, self._has_files, self._tell_all)
        application = Application(
            self._settings, self._tokens, links, self._sessions, entrance, what, self._tell, lessons
        )
        self._runner = web.AppRunner(
            application.build(),
            access_log=None,
            handle_signals=False,
            shutdown_timeout=CLOSE_SECONDS,
            keepalive_timeout=connections.IDLE_SECONDS,
            lingering_time=CLOSE_SECONDS,
        )
        await self._runner.setup()
        await connections.Site(self._runner, listener, ssl_context=secure).start()
        Lookout(self._sessions, self._tell).watch()
        self._sessions.background.repeat("serve.failed.look", USED_SECONDS, self._keep_places)
        self._tell("serve.apart", what=what)
        cells = [each.cell for each in self._sessions.running.values()]
        await asyncio.to_thread(self._tell_room, len(names), cells)
        if again:
            self._tell("serve.again", number=again)
        for name in new:
            self._tell("serve.link", name=name, link=links.known(Ticket(PUPIL, name)))
        if teacher is not None:
            self._tell("serve.teacher", link=teacher)
        self._tell("serve.at", address=base)

    async def _keep_places(self) -> None:
        await asyncio.to_thread(self._places.mark_as_used)

    def _tell_room(self, listed: int, cells: Sequence[Cell]) -> None:
        """Say that this machine is too small for the list or, without one, for all that may come."""
        settings = self._settings
        if settings.proxied:
            return
        wanted = listed or settings.most
        running: list[int] = []
        if cells:
            with contextlib.suppress(OSError):  # a system that does not tell
                running = [machine.taken(pids).memory for pids in self._sessions.mode.processes_of(cells)]
        desktop = room.remembered(self._places.server)
        found = room.room(memory.available(), memory.cores(), running, desktop, settings.most)
        if found.desktops < wanted:
            key = "serve.room.small" if listed else "serve.room.small.most"
            self._tell(key, room=found.desktops, wanted=wanted, why=found.why)

    def warm_up(self) -> None:
        """Prepare what desktops are forked from, if there will be enough of them. Raises OSError."""
        settings, mode = self._settings, self._offer.mode
        is_worth_it = settings.most >= LEAST_TO_SHARE and not settings.proxied
        if sys.platform == "linux" and mode is not None and mode.forks and is_worth_it:
            self._sessions.nursery = Nursery(starting.environment(settings.domain))
            self._sessions.nursery.begin()

    def _has_files(self, name: str) -> bool:
        return self._places.home(name).exists()

    def _names(self) -> list[str]:
        """The pupils that get a link; the bad lines of the list are told."""
        if self._settings.class_file is None:
            alone = self._settings.word is None and not self._settings.proxied
            return [ONLY_DESKTOP] if alone else []
        found = class_list.read(self._settings.class_file)
        file = str(self._settings.class_file)
        for bad in found.bad:
            self._tell("serve.class.bad", file=file, line=bad.line, text=bad.text, reason=Phrase(bad.why))
        if not found.names:
            self._tell("serve.class.empty", file=file)
        return found.names

    # -- where it listens ----------------------------------------------------------------------------------------------

    def _listener(self) -> socket.socket:
        """The socket, before anything else is done: that the port is taken is the first thing to know. Raises OSError."""
        settings = self._settings
        if settings.unix is not None:
            return _unix_listener(str(settings.unix))
        found = socket.getaddrinfo(settings.host, settings.port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)
        family, kind, protocol, _, address = found[0]
        listener = socket.socket(family, kind, protocol)
        try:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listener.bind(address)
        except OSError as error:
            listener.close()
            raise OSError(error.errno, error.strerror, f"{settings.host}:{settings.port}") from None
        return listener

    def _secure(self) -> ssl.SSLContext | None:
        if self._settings.certificate is None:
            return None
        secure = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
        try:
            secure.load_cert_chain(self._settings.certificate, self._settings.key)
        except OSError as error:
            raise OSError(error.errno, reason(error), str(self._settings.certificate)) from None
        return secure

    def _address(self, listener: socket.socket, secure: bool) -> str:
        """What pupils type, with a slash at the end."""
        settings = self._settings
        if settings.base_url:
            return settings.base_url
        if settings.unix is not None:
            return str(settings.unix)
        host, port = listener.getsockname()[:2]
        if host in ("0.0.0.0", "::"):
            host = own_address()
        shown = f"[{host}]" if ":" in host else host
        return f"http{'s' if secure else ''}://{shown}:{port}/"

    async def close(self) -> None:
        """End the desktops in order, and then the server."""
        if self._settings.keep:
            self._sessions.say_bye()
            self._tell("serve.kept", number=len(self._sessions.running))
        else:
            kept = own_home(self._settings.home) if self._settings.proxied else self._places.homes
            self._tell("serve.ending", number=len(self._sessions.running), folder=str(kept))
            await self._sessions.end_all()
        if self._runner is not None:
            await self._runner.cleanup()
        if self._settings.unix is not None:
            with contextlib.suppress(OSError):
                os.unlink(self._settings.unix)
        if self._sessions.nursery is not None:
            await asyncio.to_thread(self._sessions.nursery.close)
        self._runs.release()
        self._lock.release()


def _lessons(folder: Path | None) -> list[dict[str, Any]]:
    """What a teacher can start for all: the days, or the lessons of the folder, and the drills."""
    from day6_core.lessons.catalogue import offer

    return [{"name": each.name, "title": dict(each.title), "drill": each.is_drill} for each in offer(folder).all]


def _unix_listener(path: str) -> socket.socket:
    """Listen on a Unix socket that only this user can reach. A socket nobody listens on makes room, any other file stays."""
    if sys.platform == "win32":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    try:
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
            try:
                probe.connect(path)
            except ConnectionRefusedError:
                if stat.S_ISSOCK(os.lstat(path).st_mode):
                    os.unlink(path)
            except OSError:
                pass
        listener.bind(path)
        os.chmod(path, 0o600)  # nobody gets in before it listens
    except OSError as error:
        listener.close()
        raise OSError(error.errno, reason(error), path) from None
    return listener
