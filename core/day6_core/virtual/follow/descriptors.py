"""Waiting for descriptors: `select`, `read`, sockets, standard input."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import builtins
import io
import os
import select
import stat
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from day6_core.virtual.follow.builtin import put
from day6_core.virtual.follow.imports import when_imported
from day6_core.virtual.kernel import Kernel
from day6_core.virtual.processes import is_ready
from day6_core.virtual.surroundings import identity, outside

T = TypeVar("T")

_real_epoll, _real_poll, _real_select = select.epoll, select.poll, select.select
_real_read, _real_write = os.read, os.write
_TIOCGPTPEER = 0x5441
_kernel: Kernel
_told: Callable[[int], object]
_typed: Callable[[int], object]
_peers: dict[int, int] = {}
"""By `_socket_number`: the process at the other end of a socket, 0 if it is no Unix socket."""
_tells = True
"""Whether every process tells what it sends through Unix sockets; not after descriptors were handed on to others."""


def install(kernel: Kernel, touched: Callable[[int], object], typed: Callable[[int], object]) -> None:
    """Have what waits for descriptors follow a kernel.

    Who sends something to a process says so by `touched`, who types something for a group of processes by `typed`.
    """
    global _kernel, _told, _typed
    _kernel, _told, _typed = kernel, touched, typed
    module: Any = select
    module.epoll, module.poll = Epoll, Poll
    put(select, select=select_)
    put(os, read=read, write=write)
    when_imported("selectors", _follow_selectors)
    when_imported("socket", _follow_sockets)
    put(io, open=_opening(io.open))
    builtins.open = io.open
    _follow_input()
    follow_stdin()


def descriptors_were_shared() -> None:
    """From now on, a Unix socket may be written to by a process that doesn't say so."""
    global _tells
    _tells = False
    _kernel.told_no_more()


def wait_until_ready(fd: int, events: int, seconds: float | None) -> bool:
    """Wait until a descriptor is ready; False if that isn't so in time."""
    return bool(_look_until(lambda: is_ready(fd, events), seconds, [(fd, events)]))


def _look_until(
    look: Callable[[], T], seconds: float | None, fds: Sequence[tuple[int, int]], *, told: bool | None = None
) -> T:
    """Return what is found by looking, once it is something or after these seconds; `fds` are with the events of poll()."""
    if told is None:
        told = _are_told(fds)
    holds = not told and any(_is_outside(fd) for fd, _ in fds)
    return _kernel.look_until(look, None if seconds is None else int(seconds * 1e9), fds, told=told, holds=holds)


def _are_told(fds: Sequence[tuple[int, int]]) -> bool:
    """Whether all that can come through descriptors is told by who sends it."""
    return _tells and all(not events & ~(select.POLLIN | select.POLLPRI) and _peer_of(fd) for fd, events in fds)


def _is_outside(fd: int) -> bool:
    if identity(fd) == outside():
        return True
    if not _socket_number(fd):
        return False
    import socket

    with socket.socket(fileno=os.dup(fd)) as own:
        if own.family not in (socket.AF_INET, socket.AF_INET6):
            return False
        try:
            address = own.getpeername()[0]
        except OSError:
            return False  # it listens
    return not (address.startswith("127.") or address in ("::1", "0.0.0.0"))


def _number(file: Any) -> int:
    """The descriptor of what may be one or have one."""
    return file if isinstance(file, int) else int(file.fileno())


# -- select ------------------------------------------------------------------------------------------------------------


class Epoll:
    """As `select.epoll`."""

    def __init__(self, *args: Any) -> None:
        self._real = _real_epoll(*args)
        self._fds: dict[int, int] = {}
        self._told = False
        self._listed: list[tuple[int, int]] | None = None
        """As `_fds`; None if that has changed since it was looked whether all of it is told of."""
        self.close, self.fileno = self._real.close, self._real.fileno

    @classmethod
    def fromfd(cls, fd: int) -> Any:
        """Not followed: a real one."""
        return _real_epoll.fromfd(fd)

    def register(self, fd: Any, eventmask: int = select.EPOLLIN | select.EPOLLPRI | select.EPOLLOUT) -> None:
        """As there."""
        self._real.register(fd, eventmask)
        self._fds[_number(fd)] = eventmask
        self._listed = None

    def modify(self, fd: Any, eventmask: int) -> None:
        """As there."""
        self._real.modify(fd, eventmask)
        self._fds[_number(fd)] = eventmask
        self._listed = None

    def unregister(self, fd: Any) -> None:
        """As there."""
        self._fds.pop(_number(fd), None)
        self._listed = None
        self._real.unregister(fd)

    def poll(self, timeout: float | None = None, maxevents: int = -1) -> list[tuple[int, int]]:
        """As there."""
        fds = self._listed
        if fds is None:
            fds = self._listed = list(self._fds.items())
            self._told = _are_told(fds)
        return _look_until(lambda: self._real.poll(0, maxevents), _limit(timeout), fds, told=_tells and self._told)

    @property
    def closed(self) -> bool:
        """As there."""
        return self._real.closed

    def __enter__(self) -> Epoll:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


class Poll:
    """As what `select.poll` returns."""

    def __init__(self) -> None:
        self._real = _real_poll()
        self._fds: dict[int, int] = {}

    def register(self, fd: Any, eventmask: int = select.POLLIN | select.POLLPRI | select.POLLOUT) -> None:
        """As there."""
        self._real.register(fd, eventmask)
        self._fds[_number(fd)] = eventmask

    def modify(self, fd: Any, eventmask: int) -> None:
        """As there."""
        self._real.modify(fd, eventmask)
        self._fds[_number(fd)] = eventmask

    def unregister(self, fd: Any) -> None:
        """As there."""
        self._real.unregister(fd)
        self._fds.pop(_number(fd), None)

    def poll(self, timeout: float | None = None) -> list[tuple[int, int]]:
        """As there; the time limit is in milliseconds."""
        seconds = _limit(timeout)
        return _look_until(lambda: self._real.poll(0), seconds and seconds / 1000, list(self._fds.items()))


def _limit(timeout: float | None) -> float | None:
    """None for a negative one, too: as long as it takes."""
    return None if timeout is None or timeout < 0 else timeout


def select_(rlist: Any, wlist: Any, xlist: Any, timeout: float | None = None, /) -> Any:
    """As `select.select`."""
    if timeout is not None and timeout < 0:
        raise ValueError("timeout must be non-negative")
    lists = list(rlist), list(wlist), list(xlist)
    events = select.POLLIN, select.POLLOUT, select.POLLPRI
    fds: dict[int, int] = {}
    for each, event in zip(lists, events, strict=True):
        for fd in each:
            fds[_number(fd)] = fds.get(_number(fd), 0) | event

    def look() -> Any:
        found = _real_select(*lists, 0)
        return found if any(found) else None

    return _look_until(look, timeout, list(fds.items())) or ([], [], [])


def _follow_selectors(module: Any) -> None:
    module.EpollSelector._selector_cls = Epoll
    module.PollSelector._selector_cls = Poll
    module.SelectSelector._select = select.select


# -- read --------------------------------------------------------------------------------------------------------------


def read(fd: int, length: int, /) -> bytes:
    """As `os.read`."""
    if not stat.S_ISREG(os.fstat(fd).st_mode) and not _wait_for_input(fd):
        return b""
    return _real_read(fd, length)


def _wait_for_input(fd: int) -> bool:
    """Wait as reading would; False if a terminal has nothing and was told not to wait for it, or only for a time."""
    return not os.get_blocking(fd) or wait_until_ready(fd, select.POLLIN, _time_limit(fd) if os.isatty(fd) else None)


def _time_limit(terminal: int) -> float | None:
    """Seconds for which reading from a terminal waits, None if as long as it takes."""
    import termios

    mode, characters = termios.tcgetattr(terminal)[3::3]
    least, tenths = (n if isinstance(n, int) else n[0] for n in (characters[termios.VMIN], characters[termios.VTIME]))
    return tenths / 10 if not mode & termios.ICANON and not least else None


def write(fd: int, data: Any, /) -> int:
    """As `os.write`."""
    written = _real_write(fd, data)
    if os.isatty(fd):
        _let_arrive(fd)
    return written


def _let_arrive(fd: int) -> None:
    """Wait until what was written to a terminal from outside has come in: Linux does that on a thread of its own."""
    import fcntl

    try:
        inside = fcntl.ioctl(fd, _TIOCGPTPEER, os.O_RDONLY | os.O_NOCTTY)
    except OSError:
        return  # this is the inside
    is_ready(inside, select.POLLIN)  # waits for that thread
    os.close(inside)
    if group := os.tcgetpgrp(fd):
        _typed(group)


class Pipe(io.FileIO):
    """A pipe or terminal whose reading and writing wait so that others can go on, other threads of this process for one."""

    def readinto(self, buffer: Any) -> Any:
        """As there."""
        return super().readinto(buffer) if _wait_for_input(self.fileno()) else 0

    def read(self, size: int | None = -1) -> Any:
        """As there."""
        if size is None or size < 0:
            return self.readall()
        return super().read(size) if _wait_for_input(self.fileno()) else b""

    def readall(self) -> Any:
        """As there."""
        parts = []
        while part := self.read(65536):
            parts.append(part)
        return b"".join(parts)

    def write(self, data: Any) -> Any:
        """As there; in parts that a pipe takes at once when it takes anything."""
        left = memoryview(data).cast("B")
        size = len(left)
        while left:
            if os.get_blocking(self.fileno()):
                wait_until_ready(self.fileno(), select.POLLOUT, None)
            written = super().write(left[: select.PIPE_BUF])
            if written is None:
                return size - len(left) or None
            left = left[written:]
        return size


def _opening(real: Callable[..., Any]) -> Callable[..., Any]:
    def open(  # noqa: A001
        file: Any,
        mode: str = "r",
        buffering: int = -1,
        encoding: str | None = None,
        errors: str | None = None,
        newline: str | None = None,
        closefd: bool = True,
        opener: Any = None,
    ) -> Any:
        if not isinstance(file, int) or stat.S_ISREG(os.fstat(file).st_mode) or (buffering == 0 and "b" not in mode):
            return real(file, mode, buffering, encoding, errors, newline, closefd, opener)
        raw = Pipe(file, "".join(each for each in mode if each in "rwxa+"), closefd, opener)
        if buffering == 0:
            return raw
        cls: Any = io.BufferedRandom if "+" in mode else io.BufferedReader if "r" in mode else io.BufferedWriter
        buffer = cls(raw, buffering if buffering > 1 else io.DEFAULT_BUFFER_SIZE)
        if "b" in mode:
            return buffer
        text: Any = io.TextIOWrapper(
            buffer, encoding, errors, newline, buffering == 1 or (buffering < 0 and raw.isatty())
        )
        text.mode = mode
        return text

    return open


def follow_stdin() -> None:
    """Have standard input follow the kernel as it is now."""
    given = sys.stdin
    if not isinstance(given, io.TextIOWrapper) or stat.S_ISREG(os.fstat(given.fileno()).st_mode):
        return
    system: Any = sys
    system.stdin = system.__stdin__ = io.TextIOWrapper(
        io.BufferedReader(Pipe(given.fileno(), "rb", closefd=False)),
        encoding=given.encoding,
        errors=given.errors,
        newline="\n",
        line_buffering=given.line_buffering,
    )
    system._day6_stdin = given  # else its end would close the descriptor


def _follow_input() -> None:
    real_input = builtins.input

    def input(prompt: object = "", /) -> str:  # noqa: A001
        stdin = sys.stdin
        if stdin is not sys.__stdin__ or stdin is None or not stdin.isatty() or not sys.stdout.isatty():
            return real_input(prompt)
        sys.stdout.flush()
        sys.stderr.write(str(prompt))
        sys.stderr.flush()
        wait_until_ready(stdin.fileno(), select.POLLIN, None)
        return real_input()

    put(builtins, input=input)


# -- sockets -------------------------------------------------------------------------------------------------------------


def _peer_of(fd: int) -> int:
    """The process at the other end of a Unix socket (our own at the end of one that listens), 0 for anything else."""
    number = _socket_number(fd)
    if not number:
        return 0
    if number not in _peers:
        _peers[number] = _ask_for_peer(fd)
    return _peers[number]


def _socket_number(fd: int) -> int:
    """What tells a socket from all others, as a descriptor may be another file's a moment later; 0 if it is none."""
    try:
        found = os.fstat(fd)
    except OSError:
        return 0
    return found.st_ino if stat.S_ISSOCK(found.st_mode) else 0


def _ask_for_peer(fd: int) -> int:
    import socket
    import struct

    with socket.socket(fileno=os.dup(fd)) as own:
        if own.family != socket.AF_UNIX:
            return 0
        found: tuple[int, int, int] = struct.unpack("3i", own.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12))
    return found[0]


def _follow_sockets(module: Any) -> None:
    cls = module.socket
    unix = module.AF_UNIX

    def receives(name: str) -> None:
        original = getattr(cls, name)

        def wait_and_receive(self: Any, *args: Any, **kwargs: Any) -> Any:
            if not any(isinstance(each, int) and each & module.MSG_DONTWAIT for each in args[1:]):
                _wait_for_socket(self)
            return original(self, *args, **kwargs)

        setattr(cls, name, wait_and_receive)

    def sends(name: str) -> None:
        original = getattr(cls, name)

        def send_and_tell(self: Any, *args: Any, **kwargs: Any) -> Any:
            result = original(self, *args, **kwargs)
            if self.family == unix:
                _tell(self.fileno())
            return result

        setattr(cls, name, send_and_tell)

    for name in ("recv", "recv_into", "recvfrom", "recvfrom_into", "recvmsg", "recvmsg_into"):
        receives(name)
    receives_connection = cls._accept

    def accept(self: Any) -> Any:
        _wait_for_socket(self)
        return receives_connection(self)

    cls._accept = accept
    for name in ("send", "sendall", "sendmsg", "connect", "connect_ex", "shutdown"):
        sends(name)
    close = cls._real_close

    def real_close(self: Any, *args: Any) -> None:
        _forget(self)
        close(self, *args)

    cls._real_close = real_close


def _wait_for_socket(sock: Any) -> None:
    timeout = sock.gettimeout()
    if timeout != 0 and not wait_until_ready(sock.fileno(), select.POLLIN, timeout):
        raise TimeoutError("timed out")


def _tell(fd: int) -> None:
    _say_touched(_peer_of(fd))


def _forget(sock: Any) -> None:
    """A socket is about to be closed, which its other end sees."""
    _say_touched(_peers.pop(_socket_number(sock.fileno()), 0))


def _say_touched(pid: int) -> None:
    if pid == os.getpid():
        _kernel.touched = True
    elif pid:
        _told(pid)
