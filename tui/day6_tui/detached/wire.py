"""Messages between keeper, client and desktop: a kind of one byte, the length, the data. Nothing here blocks."""

from __future__ import annotations

import contextlib
import socket
import struct
from collections.abc import Iterator

# From a client to the keeper
HELLO = b"h"
"""JSON: the size of its terminal and the variables that describe it; without a size it has no terminal."""
INPUT = b"i"
SIZE = b"s"
"""Four numbers as TIOCSWINSZ takes them."""

STOP = b"q"
"""In place of HELLO, from the server of a class: end the desktop as SIGTERM does. The answer is that the connection ends."""

# Between an observer and the keeper, who only hands on; what is in them is `day6_core/classroom`'s
WATCH = b"w"
"""In place of HELLO: become an observer, who sees no output and types nothing. Any number may observe."""
NOTE = b"n"
"""From the desktop, what it says of itself; an observer that comes gets the last one."""
ORDER = b"O"
"""From an observer, what the desktop is asked to do."""
OBSERVERS = b"W"
"""To the desktop: how many observe it now."""

# From the keeper to a client
OUTPUT = b"o"
READY = b"r"
"""The desktop runs; for a client without a terminal."""
LEFT = b"l"
"""The desktop has given this terminal back and goes on; the data says why: ASKED, TAKEN."""
END = b"e"
"""The desktop has ended; the data is its exit status."""

ASKED, TAKEN = b"asked", b"taken"

PAGE = "day6-page"
"""TERM_PROGRAM of a client that is our page in a browser."""

# Between the keeper and the desktop
AWAY = b"a"
"""Leave the terminal."""
COME = b"c"
"""JSON: the variables that describe the terminal that is there now."""
HERE = b"+"
"""The desktop has taken the terminal: keys may come."""
GONE = b"-"
"""The desktop has left the terminal and draws nothing."""

READ_SIZE = 16384
LONGEST = 1 << 20
"""Bytes of one message; more is none of ours."""
_HEAD = struct.Struct(">cI")


def message(kind: bytes, data: bytes = b"") -> bytes:
    """A message as it is sent."""
    return _HEAD.pack(kind, len(data)) + data


class Connection:
    """One end of a connection. A peer that is gone or talks nonsense makes it `closed`."""

    def __init__(self, connection: socket.socket) -> None:
        connection.setblocking(False)
        self._connection = connection
        self._unsent = bytearray()
        self._unread = bytearray()
        self.closed = False

    def fileno(self) -> int:
        return self._connection.fileno()

    @property
    def unsent(self) -> int:
        """Bytes that the peer has not taken."""
        return len(self._unsent)

    def send(self, kind: bytes, data: bytes = b"") -> None:
        """Send as much as the peer takes now; the rest waits for `flush`."""
        self._unsent += message(kind, data)
        self.flush()

    def flush(self) -> None:
        """Go on sending; call it when the connection is writable."""
        with contextlib.suppress(BlockingIOError):
            while self._unsent and not self.closed:
                try:
                    del self._unsent[: self._connection.send(self._unsent)]
                except BlockingIOError:
                    raise
                except OSError:
                    self.closed = True
        if self.closed:
            self._unsent.clear()

    def receive(self) -> Iterator[tuple[bytes, bytes]]:
        """The messages that are complete; call it when the connection is readable."""
        try:
            data = self._connection.recv(READ_SIZE)
        except BlockingIOError:
            return
        except OSError:
            data = b""
        self.closed = self.closed or not data
        self._unread += data
        while len(self._unread) >= _HEAD.size:
            kind, length = _HEAD.unpack_from(self._unread)
            if length > LONGEST:
                self.closed = True
                return
            end = _HEAD.size + length
            if len(self._unread) < end:
                return
            found = bytes(self._unread[_HEAD.size : end])
            del self._unread[:end]
            yield kind, found

    def close(self) -> None:
        self.closed = True
        self._connection.close()
