"""What an interpreter that is ready does when a program has come: it becomes as a new one would be that is about to run it."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import _socket
import ctypes
import fcntl
import io
import json
import os
import signal
import struct
from collections.abc import Callable
from importlib import import_module
from typing import Any

from day6_core.virtual import ready
from day6_core.virtual.ready import forks, running, unseen
from day6_core.virtual.ready.shown import show

_Socket, _closerange, _open = _socket.socket, os.closerange, open
_path = [each for each in sys.path if each not in os.environ.get("PYTHONPATH", "").split(os.pathsep)]
"""The path of an interpreter without PYTHONPATH and script."""
_stdio = {name: (getattr(sys, name).encoding, getattr(sys, name).errors) for name in ("stdin", "stdout", "stderr")}
_HIGH = 100
"""Descriptors from this one on are free for moving others."""
_DUMPABLE = 4  # of prctl


def runner_of(module: str) -> Callable[[], int]:
    """Run `module`'s main(); return what is to run next, in a fork its program. That returns an exit status."""
    os.environ.pop(forks.ROOM, None)
    forks.prepare(os.environ)
    try:
        status = import_module(module).main()
    except forks.Begun as begun:
        connection = begun.connection
    else:
        return lambda: int(status)
    return _become(*_received(connection))


def _received(connection: _socket.socket) -> tuple[dict[str, Any], list[int]]:
    """What is to be run, and its descriptors. Ends this process if there is nothing."""
    for _, other in ready.waiting:
        other.detach()  # or it would close what will be a descriptor of the program's
    ready.waiting.clear()
    ready.wanted = None
    own = connection.fileno()
    null = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1, 2):
        os.dup2(null, number)
    _closerange(3, own)
    _closerange(own + 1, 1 << 16)
    size = struct.calcsize("i")
    data, rights, *_ = _Socket.recvmsg(connection, forks.HEADER.size, _socket.CMSG_SPACE(forks.MOST_FDS * size))
    if len(data) < forks.HEADER.size:
        os._exit(0)
    (length,) = forks.HEADER.unpack(data)
    request = _Socket.recv(connection, length, _socket.MSG_WAITALL)
    _Socket.send(connection, b"\0")
    connection.close()
    return json.loads(request), [number for (number,) in struct.iter_unpack("i", rights[0][2])]


def _become(request: dict[str, Any], received: list[int]) -> Callable[[], int]:
    high = [fcntl.fcntl(number, fcntl.F_DUPFD_CLOEXEC, _HIGH) for number in received]
    _closerange(3, _HIGH)
    for number, wanted in zip(high, request["fds"], strict=True):
        os.dup2(number, wanted)
    _closerange(_HIGH, _HIGH + forks.MOST_FDS)
    os.chdir(request["cwd"])
    if request["new_session"]:
        os.setsid()
    os.environ.clear()
    os.environ.update(request["env"])
    if request["before"]:
        forks.settle(*request["before"])
    _begin_signals()
    argv = request["argv"]
    show([sys.executable, *argv], os.environ)
    ctypes.CDLL(None).prctl(_DUMPABLE, 1, 0, 0, 0)
    _begin_streams()
    unseen.hide_again()
    forks.join()
    sys.argv, sys.orig_argv = list(argv), [sys.executable, *argv]
    sys.path[:] = [forks.script_folder(argv[0]), *os.environ["PYTHONPATH"].split(os.pathsep), *_path]
    return running.runner_of(argv[0])


def _begin_signals() -> None:
    """As Python does."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in (signal.SIGPIPE, signal.SIGXFSZ):
        signal.signal(number, signal.SIG_IGN)


def _begin_streams() -> None:
    """As Python does: `create_stdio` in its Python/pylifecycle.c."""
    system: Any = sys
    unbuffered = bool(os.environ.get("PYTHONUNBUFFERED"))
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        mode = "r" if name == "stdin" else "w"
        buffer: Any = _open(number, f"{mode}b", 0 if unbuffered and mode == "w" else -1, closefd=False)
        raw = getattr(buffer, "raw", buffer)
        raw.name = f"<{name}>"
        is_terminal = raw.isatty()
        encoding, errors = _stdio[name]
        stream: Any = io.TextIOWrapper(
            buffer, encoding, errors, "\n", not unbuffered and (is_terminal or name == "stderr"), unbuffered
        )
        stream.mode = mode
        setattr(system, name, stream)
        setattr(system, f"__{name}__", stream)
