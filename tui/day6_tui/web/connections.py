"""The connections of the server: nobody holds one by asking only half, and no address takes them all.

A connection waits until its request is there, and again while a form is read; then it is answered; a tab's WebSocket is kept for
as long as the tab is open, and is no longer counted here: it has shown a token. Where an address, or all of them together, have
too many, the one that has waited longest is closed, or where none waits the one whose answer takes longest: so whoever asks at
once gets in beside whoever only knocks.
"""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable

from aiohttp import web

from day6_tui.web.addresses import source

HEADER_SECONDS = 10.0
"""For the lines before a request's body; browsers send them at once."""
BODY_SECONDS = 10.0
"""For a form of at most 4 kB."""
ANSWER_SECONDS = 120.0
"""Until a client must have taken an answer: the largest file in this time is 8 kB a second."""
IDLE_SECONDS = 30.0
"""Between two requests."""
MOST_OF_ONE = 256
"""Of an address: a school behind one, with 40 browsers that open six each."""

LEAST_OF_ALL = 64


def most_of_all() -> int:
    """Half of the files that this process may open: the desktops need some, too."""
    if sys.platform == "win32":
        return 4 * MOST_OF_ONE
    import resource

    soft, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    return max(LEAST_OF_ALL, soft // 2) if soft != resource.RLIM_INFINITY else 64 * MOST_OF_ONE


class Connection(asyncio.Protocol):
    """Stands before aiohttp's part of one connection."""

    def __init__(self, within: asyncio.Protocol, book: Connections) -> None:
        self._within = within
        self._book = book
        self._loop = asyncio.get_running_loop()
        self._transport: asyncio.BaseTransport | None = None
        self._ending: asyncio.TimerHandle | None = None
        self.source = ""
        self.waits = True
        """Whether something of the request is missing."""
        self.since = self._loop.time()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Somebody has connected."""
        self._transport = transport
        peer = transport.get_extra_info("peername")
        self.source = source(peer[0]) if isinstance(peer, tuple) else ""
        self._within.connection_made(transport)
        self._end_in(HEADER_SECONDS)
        self._book.add(self)

    def connection_lost(self, error: Exception | None) -> None:
        """It is closed."""
        self._book.remove(self)
        self._stop()
        self._within.connection_lost(error)

    def data_received(self, data: bytes) -> None:
        """Hand on."""
        self._within.data_received(data)

    def eof_received(self) -> bool | None:
        """Hand on."""
        return self._within.eof_received()

    def pause_writing(self) -> None:
        """Hand on."""
        self._within.pause_writing()

    def resume_writing(self) -> None:
        """Hand on."""
        self._within.resume_writing()

    def await_more(self) -> None:
        """The rest of a request is awaited, or the next one."""
        self.waits, self.since = True, self._loop.time()

    def answer(self) -> None:
        """A request is there and is being answered."""
        self.waits, self.since = False, self._loop.time()
        self._end_in(ANSWER_SECONDS)

    def keep(self) -> None:
        """It stays open as long as both want."""
        self._stop()
        self._book.remove(self)

    def close(self) -> None:
        """Close it at once."""
        if isinstance(self._transport, asyncio.Transport):
            self._transport.abort()

    def _end_in(self, seconds: float) -> None:
        self._stop()
        self._ending = self._loop.call_later(seconds, self.close)

    def _stop(self) -> None:
        if self._ending is not None:
            self._ending.cancel()
            self._ending = None


class Connections:
    """All connections but those that are kept."""

    def __init__(self, make: Callable[[], asyncio.Protocol], most: int | None = None) -> None:
        self._make = make
        self._most = most_of_all() if most is None else most
        self._open: dict[str, dict[Connection, None]] = {}

    def __call__(self) -> Connection:
        """A protocol for a new connection."""
        return Connection(self._make(), self)

    def __len__(self) -> int:
        return sum(map(len, self._open.values()))

    def add(self, connection: Connection) -> None:
        """Count one more; where there are too many, one of the address that has the most gives way."""
        own = self._open.setdefault(connection.source, {})
        own[connection] = None
        if len(own) > MOST_OF_ONE:
            self._give_way(own, connection)
        elif len(self) > self._most:
            self._give_way(max(self._open.values(), key=len), connection)

    def _give_way(self, among: dict[Connection, None], new: Connection) -> None:
        old = (each for each in among if each is not new)
        first = min(old, key=lambda each: (not each.waits, each.since), default=new)
        self.remove(first)
        first.close()

    def remove(self, connection: Connection) -> None:
        """Count it no more."""
        own = self._open.get(connection.source, {})
        own.pop(connection, None)
        if not own:
            self._open.pop(connection.source, None)


class Site(web.SockSite):
    """Where the server listens."""

    async def start(self) -> None:
        """Begin to listen."""
        await web.BaseSite.start(self)
        within = self._runner.server
        assert within is not None
        self._server = await asyncio.get_running_loop().create_server(
            Connections(within), sock=self._sock, ssl=self._ssl_context, backlog=self._backlog,
            ssl_handshake_timeout=None if self._ssl_context is None else HEADER_SECONDS,
        )  # fmt: skip


def keep(request: web.Request) -> None:
    """The request has become a WebSocket."""
    if (connection := connection_of(request)) is not None:
        connection.keep()


def connection_of(request: web.Request) -> Connection | None:
    """The connection of a request; None if it is closed, or comes by another way than `Site`."""
    transport = request.transport
    found = None if transport is None else transport.get_protocol()
    return found if isinstance(found, Connection) else None
