"""Where keeper and clients of one desktop meet: a Unix socket in the folder of this user that the link uses, too.

There is one kept desktop for each home folder: who starts it holds the lock beside the socket for as long as it runs. So a
socket whose lock is free was left by a keeper that was killed.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
import socket
import stat
import struct
import sys
from pathlib import Path
from typing import NamedTuple

from day6_tui.core.link.paths import base_folders
from day6_tui.core.places import default_home

assert sys.platform != "win32"

INSIDE = "DAY6_INSIDE"
"""The variable by which programs of a kept desktop know its home folder."""


def home_of(given: Path | None) -> Path:
    """The home folder a desktop will have, by its one true name."""
    return (default_home() if given is None else given).expanduser().resolve()


class Held(NamedTuple):
    """What the keeper needs: the lock and the socket that clients connect to."""

    lock: int
    listener: socket.socket


def _name(home: Path) -> str:
    return f"desktop-{hashlib.sha256(os.fsencode(home)).hexdigest()[:12]}"


def connect(home: Path) -> socket.socket | None:
    """Reach the keeper of the desktop with this home; None if there is none.

    Raises LinkError if no folder is safe.
    """
    for folder in base_folders():
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            connection.connect(str(folder / _name(home)))
        except OSError:
            connection.close()
            continue
        if is_ours(connection):
            return connection
        connection.close()
    return None


def hold(home: Path) -> Held:
    """Become the one that starts the desktop with this home.

    Raises BlockingIOError if another keeper runs, LinkError if no folder is safe, OSError if there is no room for the files.
    """
    path = base_folders()[0] / _name(home)
    lock = os.open(f"{path}.lock", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC | os.O_NOFOLLOW, 0o600)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            remove(str(path))
            listener.bind(str(path))
            os.chmod(path, 0o600)
            listener.listen(8)
        except OSError:
            listener.close()
            raise
    except OSError:
        os.close(lock)
        raise
    return Held(lock, listener)


def remove(path: str) -> None:
    """Remove a socket; anything else that has its name stays. Only for the holder of the lock."""
    try:
        if stat.S_ISSOCK(os.lstat(path).st_mode):
            os.unlink(path)
    except FileNotFoundError:
        return


def is_ours(connection: socket.socket) -> bool:
    """Whether the other end is a process of this user (the folder keeps others out already)."""
    if sys.platform == "linux":
        found = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
        return bool(struct.unpack("3i", found)[1] == os.geteuid())
    if sys.platform == "darwin":
        local_peercred = 1  # sys/un.h; struct xucred begins with its version and the user
        return bool(struct.unpack_from("II", connection.getsockopt(0, local_peercred, 76))[1] == os.geteuid())
    return True
