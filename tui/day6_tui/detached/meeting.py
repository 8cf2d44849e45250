"""Where keeper and clients of one desktop meet: a Unix socket in the folder of this user that the link uses, too.

There is one kept desktop for each home folder: who starts it holds the lock beside the socket for as long as it runs. So a
socket whose lock is free was left by a keeper that was killed.
"""

from __future__ import annotations

import os
import socket
import stat
import struct
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple
from zlib import crc32

from day6_core.link.file_lock import FileLock
from day6_core.link.paths import base_folders
from day6_core.places import default_home

assert not TYPE_CHECKING or sys.platform != "win32"  # Windows has none of this

INSIDE = "DAY6_INSIDE"
"""The variable by which programs of a kept desktop know its home folder."""


def home_of(given: Path | None) -> Path:
    """The home folder a desktop will have, by its one true name."""
    return (default_home() if given is None else given).expanduser().resolve()


class Held(NamedTuple):
    """What the keeper needs: the descriptor of the lock, and the socket that clients connect to."""

    lock: int
    """-1 if it could not be had again, see `hold_again`."""
    listener: socket.socket

    def close(self) -> None:
        """Let others hold it, unless another process has inherited it."""
        self.listener.close()
        if self.lock >= 0:
            os.close(self.lock)

    @property
    def files(self) -> tuple[Path, Path]:
        """The socket and its lock."""
        path = Path(self.listener.getsockname())
        return path, path.with_name(f"{path.name}.lock")


def _name(home: Path) -> str:
    return f"desktop-{crc32(os.fsencode(home)):08x}"


def connect(home: Path, folder: Path | None = None) -> socket.socket | None:
    """Reach the keeper of the desktop with this home, in `folder` or where this user's meet; None if there is none.

    Raises LinkError if no folder is safe.
    """
    for place in base_folders() if folder is None else [folder]:
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            connection.connect(str(place / _name(home)))
        except OSError:
            connection.close()
            continue
        if is_ours(connection):
            return connection
        connection.close()
    return None


def hold(home: Path, folder: Path | None = None) -> Held:
    """Become the one that starts the desktop with this home, which is met in `folder` or where this user's are.

    Raises BlockingIOError if another keeper runs, LinkError if no folder is safe, OSError if there is no room for the files.
    """
    path = (base_folders()[0] if folder is None else folder) / _name(home)
    lock = FileLock(path.with_name(f"{path.name}.lock"))
    if not lock.try_acquire():
        raise BlockingIOError(f"{path} is in use")
    held = Held(lock.fileno(), socket.socket(socket.AF_UNIX, socket.SOCK_STREAM))
    try:
        remove(str(path))
        held.listener.bind(str(path))
        os.chmod(path, 0o600)
        held.listener.listen(8)
    except OSError:
        held.close()
        raise
    return held


def hold_again(held: Held, home: Path) -> Held:
    """Hold anew what others can't find any more, in the same folder if it can be had; as far as that is possible now."""
    folder = held.files[0].parent
    if held.lock >= 0:
        os.close(held.lock)  # it would be in our own way
    try:
        again = hold(home, folder if folder in base_folders() or folder.is_dir() else None)
    except OSError:
        return held._replace(lock=-1)
    held.listener.close()
    return again


def remove(path: str) -> None:
    """Remove a socket; anything else that has its name stays. Only for the holder of the lock."""
    try:
        if stat.S_ISSOCK(os.lstat(path).st_mode):
            os.unlink(path)
    except FileNotFoundError:
        return


def is_ours(connection: socket.socket) -> bool:
    """Whether the other end is a process of this user, or root's (the folder keeps others out already)."""
    allowed = (0, os.geteuid())  # root: the server whose pupils are Unix users of their own
    if sys.platform == "linux":
        found = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
        return bool(struct.unpack("3i", found)[1] in allowed)
    if sys.platform == "darwin":
        local_peercred = 1  # sys/un.h; struct xucred begins with its version and the user
        return bool(struct.unpack_from("II", connection.getsockopt(0, local_peercred, 76))[1] in allowed)
    return True
