"""Holds the pseudo-terminal of a desktop: `python -m day6_tui.detached.keeper`, started by `client.start`.

It reads whatever the desktop writes, for as long as the desktop runs, and hands it to the client that is attached. Without one,
the desktop is told to draw nothing. It ends with the desktop; if it is killed, the desktop sees its terminal hang up.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import select
import signal
import socket
import struct
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from day6_core.link.kept_files import KeptFiles
from day6_tui import turns
from day6_tui.detached import meeting, wire
from day6_tui.detached.wire import Connection

assert not TYPE_CHECKING or sys.platform != "win32"  # Windows has none of this

UNSENT = 8192
"""Bytes that may wait for a client: more, and the desktop draws fewer frames, as on any slow terminal."""

UNTYPED = 65536
"""Bytes of keys that may wait for the desktop; more stay with the client."""

QUIET = 0.05
"""Seconds in which nothing comes from the pseudo-terminal when all that was written has come."""

LEAVE_SECONDS = 3.0
"""What the desktop gets for leaving one terminal before it is given another."""

LOOK_SECONDS = 1.0
"""Between two looks whether clients can still find us."""

STUCK_SECONDS = 5.0
"""A client that takes nothing for so long is treated as if it had left, until it takes what waits: a closed laptop."""

MOST_OBSERVERS = 16

MOST_ORDERS = 1 << 16
"""Bytes of orders that may wait for the desktop; more are dropped."""

MOST_UNSENT = 1 << 20
"""Bytes that are kept at most for a client that the desktop is leaving."""

LAST_SECONDS = 5.0
"""What a client gets to take the last output."""

_SIZE = struct.Struct("HHHH")
_FIXED_SIZE = ("LINES", "COLUMNS")
"""Variables that would hold against the size of the terminal."""


Become = Callable[[list[str], dict[str, str]], NoReturn]
"""How this process becomes the program with these words and variables."""

Hello = dict[str, Any]
"""`environ`: the variables that describe a terminal; `size`: its size as TIOCSWINSZ takes it, None without a terminal."""


class Keeper:
    """The desktop, its terminal, and who looks at it."""

    def __init__(
        self, held: meeting.Held, first: Connection, home: str, folder: str, words: list[str], become: Become
    ) -> None:
        self._held = held
        self._kept = KeptFiles()
        self._looked_at = math.inf
        """When it was looked whether we can be found; never where we can't see it, as in the cells of a server."""
        self._home, self._folder, self._words = home, folder, words
        self._become = become
        self._arrived = [first]
        """Clients that have not said hello."""
        self._client: Connection | None = None
        self._hello: Hello = {}
        """How the terminal of the client is."""
        self._next: tuple[Connection, Hello] | None = None
        """The client that gets the desktop as soon as the present one has been left."""
        self._parting: list[tuple[Connection, float]] = []
        """Clients that only have to take what was sent, and until when."""
        self._observers: list[Connection] = []
        """Who hears the desktop's notes."""
        self._behind: set[Connection] = set()
        """Those who have yet to take an older note, and then get the last one: a note tells everything."""
        self._note = b""
        """The last one."""
        self._is_here = False
        """Whether the desktop draws, or is about to."""
        self._leave_by: float | None = None
        """When the desktop, which was told to leave its terminal, must have done so."""
        self._overdue = 0
        """How often it was not waited for any longer; it will say that it is gone all the same."""
        self._has_begun = False
        """Whether the desktop listens to us."""
        self._reads_keys = False
        self._typed = bytearray()
        self._is_stuck = False
        """Whether the client takes nothing, and the desktop has left it."""
        self._took_at = 0.0
        """When the client took something last, or had nothing to take."""
        self._pid = 0
        """The desktop, 0 before it was started."""
        self._master = -1
        """Its terminal, -1 when it is closed."""
        self._desktop: Connection

    def run(self) -> None:
        """Serve until the desktop has ended."""
        self._wakes, writing = os.pipe()
        os.set_blocking(self._wakes, False)
        os.set_blocking(writing, False)
        signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
        signal.signal(signal.SIGCHLD, lambda number, frame: None)
        signal.signal(signal.SIGTERM, self._hand_on)
        for ignored in (signal.SIGINT, signal.SIGHUP, signal.SIGPIPE):
            signal.signal(ignored, signal.SIG_IGN)
        if all(map(os.path.lexists, self._held.files)):
            self._looked_at = 0.0
        status: int | None = None
        while status is None and (self._pid or self._arrived):  # who starts us may be gone before it has said a word
            self._serve()
            status = self._ended() if self._pid else None
        self._drain()
        with contextlib.suppress(OSError):  # the folder is not ours where a server started us: it removes the socket
            meeting.remove(str(self._held.files[0]))
        self._held.close()  # before anybody is told: the next desktop may start at once
        for line in [self._client, self._next and self._next[0], *self._observers]:
            if line is not None:
                line.send(wire.END, str(status).encode())
                self._part(line)
        self._serve_parting([])  # who has taken everything
        while self._parting:
            self._serve_parting(select.select([], self._unsent_parting(), [], LAST_SECONDS)[1])

    # -- waiting -------------------------------------------------------------------------------------------------------

    def _serve(self) -> None:
        """Wait until something can be done, and do it."""
        client, upcoming = self._client, self._next and self._next[0]
        readers: list[Any] = [self._wakes, self._held.listener, *self._arrived, *self._observers]
        writers: list[Any] = [*self._unsent_parting(), *(line for line in self._observers if line.unsent)]
        if self._pid and not self._desktop.closed:
            readers.append(self._desktop)
            writers += [self._desktop] if self._desktop.unsent else []
        if self._master >= 0 and self._takes_output:
            readers.append(self._master)
        if self._master >= 0 and self._typed and self._reads_keys:
            writers.append(self._master)
        if client is not None and len(self._typed) < UNTYPED:
            readers.append(client)
        if upcoming is not None:
            readers.append(upcoming)
        writers += [line for line in (client, upcoming) if line is not None and line.unsent]
        readable, writable, _ = select.select(readers, writers, [], self._patience())
        if self._wakes in readable:
            os.read(self._wakes, 64)
        if self._held.listener in readable:
            self._accept()
        self._serve_parting(writable)
        if self._master in writable:
            self._type()
        if self._master in readable:
            self._hand_out(self._read())
        for line in (client, upcoming):
            if line is not None and line in writable:
                line.flush()
                self._took_at = time.monotonic() if line is client else self._took_at
        for line in [line for line in (*self._observers, *([self._desktop] if self._pid else ())) if line in writable]:
            line.flush()
        self._tell_behind()
        if self._pid and self._desktop in readable:
            for kind, data in self._desktop.receive():
                self._hear_desktop(kind, data)
        heard = (*self._arrived, client, upcoming, *self._observers)
        for line in [line for line in heard if line is not None and line in readable]:
            for kind, data in line.receive():
                self._hear(line, kind, data)
        self._forget_closed()
        self._look_at_clock()

    @property
    def _takes_output(self) -> bool:
        """Whether to read what the desktop writes; it never has to wait for one that is not looking."""
        client = self._client
        return client is None or self._is_stuck or self._leave_by is not None or client.unsent < UNSENT

    def _patience(self) -> float | None:
        """Seconds until something has to be done without being asked."""
        deadlines = [until for _, until in self._parting]
        if self._looked_at < math.inf:
            deadlines.append(self._looked_at + LOOK_SECONDS)
        if self._leave_by is not None:
            deadlines.append(self._leave_by)
        if self._client is not None and self._client.unsent and not self._is_stuck:
            deadlines.append(self._took_at + STUCK_SECONDS)
        return max(0.0, min(deadlines) - time.monotonic()) if deadlines else None

    def _look_at_clock(self) -> None:
        now = time.monotonic()
        if now >= self._looked_at + LOOK_SECONDS:
            self._looked_at = now
            if self._held.lock < 0 or self._kept.are_gone(self._held.files):
                self._held, self._kept = meeting.hold_again(self._held, Path(self._home)), KeptFiles()
                self._held.listener.setblocking(False)
        if self._leave_by is not None and now >= self._leave_by:
            self._overdue += 1
            self._left()
        client = self._client
        if client is None:
            return
        if not client.unsent:
            self._took_at = now
            if self._is_stuck and not self._is_here:
                self._come()
        elif self._is_here and not self._is_stuck and now - self._took_at >= STUCK_SECONDS:
            self._is_stuck = True
            self._send_away()

    # -- the desktop ---------------------------------------------------------------------------------------------------

    def _start(self, size: bytes | None) -> None:
        import pty

        ours, theirs = socket.socketpair()
        theirs.set_inheritable(True)
        environ = {name: value for name, value in os.environ.items() if name not in _FIXED_SIZE}
        environ["DAY6_KEEPER"] = f"{theirs.fileno()}:{self._folder}"
        environ[meeting.INSIDE] = self._home
        reading, writing = os.pipe()
        self._pid, self._master = pty.fork()
        if self._pid == 0:
            try:
                os.close(writing)
                os.read(reading, 1)  # until the size is set: set from here it could come after the next one
                os.close(reading)
                for number in (signal.SIGINT, signal.SIGHUP, signal.SIGPIPE):
                    signal.signal(number, signal.SIG_DFL)
                self._become([sys.executable, "-m", "day6_tui.main", *self._words], environ)
            finally:
                os._exit(127)
        _set_size(self._master, size)
        os.close(reading)
        os.close(writing)
        theirs.close()
        os.set_blocking(self._master, False)
        self._desktop = Connection(ours)
        self._is_here = self._reads_keys = True

    def _ended(self) -> int | None:
        """The desktop's exit status once it has ended; 128 + the number of a signal."""
        pid, status = os.waitpid(self._pid, os.WNOHANG)
        if not pid:
            return None
        code = os.waitstatus_to_exitcode(status)
        return code if code >= 0 else 128 - code

    def _hand_on(self, number: int, frame: object) -> None:
        """A signal for us is one for the desktop: it ends, and we do."""
        if not self._pid:
            os._exit(128 + number)
        with contextlib.suppress(ProcessLookupError):
            os.kill(self._pid, number)

    def _read(self) -> bytes:
        try:
            data = os.read(self._master, wire.READ_SIZE)
        except BlockingIOError:
            return b""
        except OSError:  # Linux; macOS reads nothing
            data = b""
        if not data:  # nobody has the terminal open any more
            os.close(self._master)
            self._master = -1
        return data

    def _drain(self) -> None:
        """Read what the desktop has written until now."""
        while self._master >= 0 and select.select([self._master], [], [], QUIET)[0]:
            self._hand_out(self._read())

    def _hand_out(self, data: bytes) -> None:
        client = self._client
        if data and client is not None and not self._is_stuck and client.unsent < MOST_UNSENT:
            client.send(wire.OUTPUT, data)

    def _type(self) -> None:
        """Hand keys to the desktop, as many as it takes."""
        if self._typed:
            with contextlib.suppress(OSError):
                del self._typed[: os.write(self._master, self._typed[:4096])]

    def _hear_desktop(self, kind: bytes, data: bytes) -> None:
        if kind == wire.NOTE:
            self._note = data
            for line in self._observers:
                self._tell_observer(line)
        elif kind == wire.HERE:
            if not self._has_begun:
                self._has_begun = True
                self._count_observers()
            self._reads_keys = True
            if self._client is not None and self._hello.get("size") is None:
                self._client.send(wire.READY)
                self._part(self._client)
            if self._client is None or self._next is not None:
                self._send_away()
        elif kind == wire.GONE:
            if self._overdue:
                self._overdue -= 1
            elif self._is_here:
                self._left()

    def _send_away(self) -> None:
        """Tell the desktop to leave the terminal, now or when it has begun; `_left` follows."""
        if self._has_begun and self._is_here and self._leave_by is None:
            self._reads_keys = False
            self._typed.clear()
            self._leave_by = time.monotonic() + LEAVE_SECONDS
            self._desktop.send(wire.AWAY)

    def _left(self) -> None:
        """The desktop has left the terminal, by itself or because it was told to (or it is not waited for any longer)."""
        self._drain()
        self._is_here = self._reads_keys = False
        self._leave_by = None
        if self._client is not None and (self._next is not None or not self._is_stuck):
            self._client.send(wire.LEFT, wire.ASKED if self._next is None else wire.TAKEN)
            self._part(self._client)
        if self._next is not None:
            (self._client, self._hello), self._next = self._next, None
            self._come()

    def _come(self) -> None:
        """Let the desktop draw on the terminal of the client."""
        _set_size(self._master, self._hello["size"])
        self._is_here, self._is_stuck = True, False
        self._took_at = time.monotonic()
        self._desktop.send(wire.COME, json.dumps(self._hello["environ"]).encode())

    # -- clients -------------------------------------------------------------------------------------------------------

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            connection, _ = self._held.listener.accept()
            if not meeting.is_ours(connection):
                connection.close()
                return
            # Little waits in the system: otherwise keys would be answered late over a slow line.
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, UNSENT)
            self._arrived.append(Connection(connection))

    def _hear(self, line: Connection, kind: bytes, data: bytes) -> None:
        if line in self._arrived and kind == wire.WATCH:
            self._arrived.remove(line)
            self._observe(line)
        elif line in self._observers:
            if kind == wire.ORDER and self._has_begun and self._desktop.unsent < MOST_ORDERS:
                self._desktop.send(wire.ORDER, data)
        elif line in self._arrived and kind == wire.STOP:
            self._hand_on(signal.SIGTERM, None)  # the line stays open until this process ends
        elif line in self._arrived:
            hello = _hello(data) if kind == wire.HELLO else None
            if hello is None:
                line.close()
                return
            self._arrived.remove(line)
            self._greet(line, hello)
        elif kind == wire.SIZE and (size := _size(data)) is not None:
            if line is self._client:
                self._hello["size"] = size
                if self._is_here and self._leave_by is None:
                    _set_size(self._master, size)
            elif self._next is not None and line is self._next[0]:
                self._next[1]["size"] = size
        elif kind == wire.INPUT and line is self._client:
            self._typed += data
            if self._master >= 0 and self._reads_keys:
                self._type()  # not in the next round, behind a frame

    def _greet(self, line: Connection, hello: Hello) -> None:
        if not self._pid:
            self._client, self._hello = line, hello
            self._took_at = time.monotonic()
            self._start(hello["size"])
            return
        if hello["size"] is None:  # only who starts the desktop may have no terminal
            line.close()
            return
        if self._next is not None:
            self._next[0].send(wire.LEFT, wire.TAKEN)
            self._part(self._next[0])
        self._next = line, hello
        if self._is_here:
            self._send_away()
        else:
            self._left()

    def _observe(self, line: Connection) -> None:
        """Let one more hear what the desktop says of itself."""
        if len(self._observers) >= MOST_OBSERVERS:
            line.close()
            return
        self._observers.append(line)
        if self._note:
            self._tell_observer(line)
        self._count_observers()

    def _tell_observer(self, line: Connection) -> None:
        if line.unsent:
            self._behind.add(line)
        else:
            line.send(wire.NOTE, self._note)

    def _tell_behind(self) -> None:
        for line in [line for line in self._behind if not line.unsent]:
            self._behind.discard(line)
            self._tell_observer(line)

    def _count_observers(self) -> None:
        if self._has_begun:
            self._desktop.send(wire.OBSERVERS, str(len(self._observers)).encode())

    def _part(self, line: Connection) -> None:
        """Let a client go as soon as it has taken what was sent."""
        if line is self._client:
            self._client, self._is_stuck = None, False
        self._parting.append((line, time.monotonic() + LAST_SECONDS))

    def _unsent_parting(self) -> list[Connection]:
        return [line for line, _ in self._parting if line.unsent and not line.closed]

    def _serve_parting(self, writable: list[Any]) -> None:
        now = time.monotonic()
        for line, until in list(self._parting):
            if line in writable:
                line.flush()
            if line.closed or not line.unsent or now >= until:
                self._parting.remove((line, until))
                line.close()

    def _forget_closed(self) -> None:
        for line in [line for line in self._arrived if line.closed]:
            self._arrived.remove(line)
            line.close()
        if lost := [line for line in self._observers if line.closed]:
            for line in lost:
                self._observers.remove(line)
                self._behind.discard(line)
                line.close()
            self._count_observers()
        if self._next is not None and self._next[0].closed:
            self._next[0].close()
            self._next = None
        if self._client is not None and self._client.closed:
            self._client.close()
            self._client, self._is_stuck = None, False
            self._typed.clear()
            if self._next is None:
                self._send_away()


def _hello(data: bytes) -> Hello | None:
    """What a client says first; None if it is nonsense."""
    try:
        found = json.loads(data)
        environ, size = found["environ"], found["size"]
        told = {str(name): str(value) for name, value in environ.items()}
        return {"environ": told, "size": None if size is None else _SIZE.pack(*size)}
    except (ValueError, TypeError, KeyError, AttributeError, struct.error):
        return None


def _size(data: bytes) -> bytes | None:
    return data if len(data) == _SIZE.size else None


def _set_size(terminal: int, size: bytes | None) -> None:
    import fcntl
    import termios

    if terminal >= 0:
        with contextlib.suppress(OSError):
            fcntl.ioctl(terminal, termios.TIOCSWINSZ, _SIZE.pack(24, 80, 0, 0) if size is None else size)


def _execute(argv: list[str], environ: dict[str, str]) -> NoReturn:
    os.execve(argv[0], argv, environ)


def main(arguments: list[str], become: Become = _execute) -> None:
    """`keeper LISTENER LOCK FIRST HOME FOLDER WORD…`: three descriptors, two folders, what the desktop is started with."""
    listener, lock, first = (int(word) for word in arguments[:3])
    home, folder, *words = arguments[3:]
    turns.keep_from_children()
    turns.take_short()  # every key passes here
    held = meeting.Held(lock, socket.socket(fileno=listener))
    for descriptor in (listener, lock, first):
        os.set_inheritable(descriptor, False)
    held.listener.setblocking(False)
    os.chdir("/")  # else the desktop would import modules from where we are; it goes to its folder by itself
    Keeper(held, Connection(socket.socket(fileno=first)), home, folder, words, become).run()


if __name__ == "__main__":
    main(sys.argv[1:])
