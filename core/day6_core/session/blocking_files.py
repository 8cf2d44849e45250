"""Keeps the thread that runs all programs from opening a file that could block them all: a pipe without a writer, a terminal.

File names come from the user everywhere: `check_urdf f`, `--params-file f`, `rviz2 -d f`, a package.xml. So `open` itself fails,
with an error of the system. Code that reads in pieces and can wait opens with O_NONBLOCK, which is allowed.
"""

from __future__ import annotations

import errno
import os
import stat
import sys
import threading
from pathlib import Path
from typing import Any

WITHOUT_END = ("/dev/zero", "/dev/full", "/dev/random", "/dev/urandom")
"""Devices that may be written to, but whose input has no end."""

_threads: set[int] = set()
_installed = False


def begin() -> bool:
    """From now on opening a blocking file fails on this thread. Returns False if that was so already."""
    global _installed
    thread = threading.get_ident()
    if sys.platform == "win32" or thread in _threads:
        return False
    if not _installed:
        _installed = True
        sys.addaudithook(_check)
    _threads.add(thread)
    return True


def end() -> None:
    """Let this thread open such files again."""
    _threads.discard(threading.get_ident())


def refuse(path: str, mode: int, *, writing: bool) -> None:
    """Refuse a file that could block; `mode` is its `st_mode`.

    Raises:
        OSError: it is a named pipe, a terminal, or (unless `writing`) a device without end.
    """
    if stat.S_ISFIFO(mode):
        raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN), path)
    if not stat.S_ISCHR(mode) or path == os.devnull:
        return
    if path not in WITHOUT_END:  # a terminal: the user's own, on which the desktop is drawn
        raise OSError(errno.ENXIO, os.strerror(errno.ENXIO), path)
    if not writing:
        raise OSError(errno.ENOMEM, os.strerror(errno.ENOMEM), path)


def read_at_most(path: Path, most: int) -> bytes:
    """Read a file at once, on any thread.

    Raises:
        OSError: it cannot be read, or could block (see `refuse`).
        ValueError: it has more than `most` bytes.
    """
    refuse(str(path), path.stat().st_mode, writing=False)
    with path.open("rb") as file:
        data = file.read(most + 1)
    if len(data) > most:
        raise ValueError(f"more than {most} bytes")
    return data


def _check(event: str, arguments: tuple[Any, ...]) -> None:
    if sys.platform == "win32" or event != "open" or threading.get_ident() not in _threads:
        return
    path, _, flags = arguments
    if not isinstance(path, (str, bytes)) or flags & os.O_NONBLOCK:
        return
    try:
        mode = os.stat(path).st_mode
    except (OSError, ValueError):
        return
    refuse(os.fsdecode(path), mode, writing=bool(flags & (os.O_WRONLY | os.O_RDWR)))
