"""The sockets of our engine in the meeting place: each process listens on its own, and connects to all that are there already.

So there is nobody in the middle, and nobody's end matters to the others. A process listens before it looks around: of two that
start at once, at least one finds the other.
"""

from __future__ import annotations

import os
import socket
import sys
from collections.abc import Iterator
from typing import NamedTuple

from day6_core.link.paths import MeetingPlace, Neighbour, neighbours, password
from day6_core.whole_file import PRIVATE, replace_file

_BACKLOG = 128
"""Processes that start while this one is stopped."""
_SECONDS = 1.0
"""That connecting may take; the system answers at once."""


class Config(NamedTuple):
    """What a session is opened with: where, and as whom."""

    place: MeetingPlace
    zid: str

    @property
    def password(self) -> str:
        """What all of this user's processes know, '' where the folder keeps others out. Raises OSError."""
        return password(self.place) if self.place.tcp else ""


def listen(config: Config) -> socket.socket:
    """Return the socket on which this process can be reached. Raises OSError."""
    path = config.place.own_socket(config.zid)
    listener = _new_socket(config.place)
    if sys.platform == "win32":
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
    try:
        listener.bind(("127.0.0.1", 0) if config.place.tcp else os.fspath(path))
        listener.listen(_BACKLOG)
        listener.setblocking(False)
        if config.place.tcp:
            port = str(port_of(listener)).encode()
            replace_file(path, port, mode=PRIVATE, sync=False, follow=False)
    except OSError:
        listener.close()
        raise
    return listener


def port_of(listener: socket.socket) -> int:
    """Return the port of a listening socket, 0 of a Unix socket."""
    name = listener.getsockname()
    return int(name[1]) if isinstance(name, tuple) else 0


def connect(config: Config) -> Iterator[tuple[Neighbour, int, socket.socket]]:
    """Connect to the other processes that can be reached; yield each with its port and the socket."""
    for each in list(neighbours(config.place)):
        if each.zid == config.zid:
            continue
        port = 0
        connected = _new_socket(config.place)
        try:
            if config.place.tcp:
                port = int(each.path.read_text(encoding="ascii"))
                connected.settimeout(_SECONDS)
            else:
                connected.setblocking(False)
            connected.connect(("127.0.0.1", port) if config.place.tcp else os.fspath(each.path))
        except (OSError, ValueError):  # it was killed, or is about to listen and will connect to us
            connected.close()
        else:
            yield each, port, connected


def _new_socket(place: MeetingPlace) -> socket.socket:
    if place.tcp or sys.platform == "win32":
        return socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    return socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
