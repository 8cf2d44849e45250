"""The connections of a session to all other processes: how they come about, are read, and end."""

from __future__ import annotations

import socket
import time
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from typing import Protocol

from day6_core.link.local.connection import Connection
from day6_core.link.local.frames import Frame, Malformed
from day6_core.link.local.handshake import Handshake
from day6_core.link.local.loop import Loop
from day6_core.link.local.place import Config, connect, listen, port_of

_PROOF_SECONDS = 5.0
"""For a program that connects over TCP to show that it is one of ours."""
_FULL_SECONDS = 0.2
"""Before connections are accepted again, when the system refuses one more."""
_LINGER_SECONDS = 0.5
"""That the others get to take the last messages."""
_POLL_SECONDS = 0.005


class Party(Protocol):
    """Who uses the connections; called by the session's thread."""

    def greet(self, connection: Connection) -> None:
        """Tell a process that has just been connected what there is here."""

    def take(self, connection: Connection, frame: Frame) -> None:
        """Take what came. Raises Malformed."""

    def miss(self, connection: Connection) -> None:
        """Forget a process whose connection has ended."""


class Mesh:
    """Opened with the process's own socket; all else is done by the thread of `loop`, which may wait for others."""

    def __init__(self, config: Config, loop: Loop, party: Party) -> None:
        self._config = config
        self._loop = loop
        self._party = party
        self._password = config.password
        self.connections: dict[Connection, None] = {}
        """In the order in which they came: what is told to all goes out in the same order each time."""
        self._called: set[str] = set()
        """The sessions that this one has connected to."""
        self._listener = listen(config)
        self._port = port_of(self._listener)
        loop.do(self._begin)

    def finish(self, then: Callable[[], None]) -> None:
        """Accept nobody any more, let the others take what waits for them, and close."""
        self._hang_up()
        self._linger(time.monotonic() + _LINGER_SECONDS, then)

    def close(self) -> None:
        """Close everything at once."""
        self._hang_up()
        for each in list(self.connections):
            self._drop(each)

    def abandon(self) -> None:
        """In a forked child: close the copies of the sockets, or the others would not notice when the parent dies."""
        for each in (self._listener, *(connection.socket for connection in list(self.connections))):
            each.close()

    def _hang_up(self) -> None:
        if self._listener.fileno() != -1:
            self._loop.forget(self._listener)
            self._listener.close()
            with suppress(OSError):  # the folder is gone, or Windows has the file open for somebody else
                self._config.place.own_socket(self._config.zid).unlink()

    def _linger(self, until: float, then: Callable[[], None]) -> None:
        unsent = [each for each in self.connections if each.waiting and not each.is_stalled]
        if not unsent and self._config.place.tcp:
            # Closing now would take back what the other side has not read yet, if it has sent something in between.
            for each in self.connections:
                each.say_goodbye()
            unsent = [each for each in self.connections if not each.is_stalled]
        if unsent and time.monotonic() < until:
            self._loop.later(_POLL_SECONDS, partial(self._linger, until, then))
        else:
            then()

    # -- connecting ----------------------------------------------------------------------------------------------------

    def _begin(self) -> None:
        with suppress(OSError):  # the folder is gone
            for neighbour, port, connected in connect(self._config):
                self._called.add(neighbour.zid)
                self._welcome(connected, calling=True, port=port)
        self._watch()

    def _watch(self) -> None:
        if self._listener.fileno() != -1:
            self._loop.watch(self._listener, self._accept)

    def _accept(self) -> None:
        try:
            connected, _ = self._listener.accept()
        except BlockingIOError:
            return
        except OSError:
            self._loop.forget(self._listener)
            self._loop.later(_FULL_SECONDS, self._watch)
            return
        connection = self._welcome(connected, calling=False, port=self._port)
        if self._password:
            self._loop.later(_PROOF_SECONDS, partial(self._drop_stranger, connection))

    def _drop_stranger(self, connection: Connection) -> None:
        if not connection.handshake.done:
            self._drop(connection)

    def _welcome(self, connected: socket.socket, *, calling: bool, port: int) -> Connection:
        if connected.family == socket.AF_INET:
            connected.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        handshake = Handshake(
            self._config.zid, calling=calling, password=self._password, port=port, is_welcome=self._is_welcome
        )
        connection = Connection(connected, handshake, self._on_backlog)
        self.connections[connection] = None
        self._loop.watch(connected, partial(self._read, connection))
        if calling:
            connection.send(handshake.begin())
        return connection

    def _is_welcome(self, zid: str) -> bool:
        """Whether a session may connect: of two that connected to each other at once, only the connection of one is kept."""
        return zid not in self._called or self._config.zid < zid

    # -- reading and writing -------------------------------------------------------------------------------------------

    def _read(self, connection: Connection) -> None:
        try:
            for frame in connection.reader.read(connection.socket):
                if connection.handshake.done:
                    self._party.take(connection, frame)
                else:
                    self._shake_hands(connection, frame)
        except BlockingIOError:
            return
        except (EOFError, OSError, Malformed):
            self._drop(connection)

    def _shake_hands(self, connection: Connection, frame: Frame) -> None:
        for answer in connection.handshake.take(frame):
            connection.send(answer)
        if connection.handshake.done:
            connection.reader.is_let_in = True
            self._party.greet(connection)

    def _on_backlog(self, connection: Connection) -> None:
        self._loop.do(partial(self._write, connection))

    def _write(self, connection: Connection) -> None:
        if connection not in self.connections:
            return
        everything = connection.flush()
        if connection.broken:
            self._drop(connection)
        else:
            on_writable = None if everything else partial(self._write, connection)
            self._loop.watch(connection.socket, partial(self._read, connection), on_writable)

    def _drop(self, connection: Connection) -> None:
        if connection not in self.connections:
            return
        del self.connections[connection]
        self._loop.forget(connection.socket)
        connection.close()
        self._party.miss(connection)
