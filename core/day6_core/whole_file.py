"""Writes a file whole or not at all: into a temporary file beside it, which then takes its name.

The old file stays unchanged until the new contents are on the disk, whatever happens: a full disk, a folder that disappears,
`kill -9`. The system itself applies the umask to the mode of a new file, so it need not be read (which a process with threads
cannot do safely).
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any, BinaryIO

PRIVATE = 0o600
"""The mode of private files: typed commands, unsaved texts, passwords."""

_PRIVATE_FOLDER = 0o700

_CONTROLLING = 5 << 8
"""The number of /dev/tty on Linux (Documentation/admin-guide/devices.txt)."""


def open_at_once(path: str, flags: int) -> int:
    """An opener for `open` that does not wait for the other end where a path leads to a pipe."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


@contextlib.contextmanager
def replacing(target: Path, *, mode: int | None = None, sync: bool = True, follow: bool = True) -> Iterator[BinaryIO]:
    """Open a file for writing that gets the name `target` at the end of the block; after an error `target` is unchanged.

    `mode` is that of the new file, less the umask; None keeps that of the old file. Without `sync` a power cut may still leave
    an empty file. A link is followed, or replaced without `follow`; a device is written to.

    Raises:
        OSError: the file cannot be written; the error names it.
    """
    if follow:
        target = Path(os.path.realpath(target))
    temporary = target.parent / f".day6-{os.urandom(6).hex()}"
    with _named(target, temporary):
        before = _before(target)
        if before is not None and not stat.S_ISREG(before.st_mode):
            with open(target, "wb") as device:  # a device must not be replaced by a file
                refuse_own_terminal(device.fileno(), device)
                yield device
            return
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
        number = os.open(temporary, flags, 0o666 if mode is None else mode)
        try:
            with open(temporary, "wb", opener=lambda path, flags: number) as file:  # so that it has a name
                if before is not None and mode is None:
                    _keep_rights(file.fileno(), before)
                yield file
                file.flush()
                if sync:
                    os.fsync(file.fileno())
            os.replace(temporary, target)
        except BaseException:
            with contextlib.suppress(OSError):
                os.unlink(temporary)
            raise


def replace_file(target: Path, data: bytes, *, mode: int | None = None, sync: bool = True, follow: bool = True) -> None:
    """Make `data` the contents of `target`; see `replacing`.

    Raises:
        OSError: it cannot be written; the old file is unchanged.
    """
    with replacing(target, mode=mode, sync=sync, follow=follow) as file:
        file.write(data)


def refuse_own_terminal(number: int, opened: IO[Any]) -> None:
    """Close a file that turns out to be the terminal we run in, where only the screen may be drawn.

    Names that mean a command's own terminal do not get here (`day6_core/shell/own_streams.py`).

    Raises:
        OSError: the file is that terminal.
    """
    if sys.platform == "win32" or not os.isatty(number):
        return
    device = os.fstat(number).st_rdev
    if device == _CONTROLLING or any(os.isatty(own) and os.fstat(own).st_rdev == device for own in (0, 1, 2)):
        opened.close()
        raise OSError(errno.ENXIO, os.strerror(errno.ENXIO))


def must_stay(target: Path) -> bool:
    """Return whether the file at `target` (links are followed) must be overwritten rather than replaced.

    `replace_file` would lose its other names (hard links), an owner or group that a new file cannot get, an access list or other
    attributes, and cannot create a file in a read-only folder. `overwrite_file` is for those.
    """
    if sys.platform == "win32":
        return False
    real = os.path.realpath(target)
    try:
        found = os.stat(real)
    except OSError:
        return False
    if not stat.S_ISREG(found.st_mode):
        return False
    others = os.geteuid() != 0 and (found.st_uid != os.geteuid() or found.st_gid not in (os.getegid(), *os.getgroups()))
    return found.st_nlink > 1 or others or not os.access(os.path.dirname(real), os.W_OK) or _has_attributes(real)


def overwrite_file(target: Path, data: bytes) -> None:
    """Make `data` the contents of an existing file, which stays the same file.

    The part beyond the old size is written first: if it does not fit, the file is unchanged. A crash in the middle leaves it
    half written, so the caller must have a copy of `data` on the disk.

    Raises:
        OSError: the file cannot be written.
    """
    with _named(target):
        number = os.open(target, os.O_WRONLY | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0))
        try:
            size = os.fstat(number).st_size
            try:
                _write_at(number, data[size:], size)
                os.fsync(number)
            except OSError:
                os.ftruncate(number, size)
                raise
            _write_at(number, data[:size], 0)
            os.ftruncate(number, len(data))
            os.fsync(number)
        finally:
            os.close(number)


def _write_at(number: int, data: bytes, place: int) -> None:
    os.lseek(number, place, os.SEEK_SET)
    rest = memoryview(data)
    while rest:
        rest = rest[os.write(number, rest) :]


def _has_attributes(real: str) -> bool:
    """Return whether a file has extended attributes, such as an access list. (SELinux labels do not count.)"""
    if sys.platform != "linux":
        return False
    try:
        return any(name != "security.selinux" for name in os.listxattr(real))
    except OSError:
        return False


def write_private(target: Path, data: bytes) -> None:
    """Replace a file that only this user can read, in a folder that only this user can enter. Raises OSError."""
    make_private_folder(target.parent)
    replace_file(target, data, mode=PRIVATE)


def append_private(target: Path, data: bytes) -> None:
    """Append to a file and make it readable for this user only. Raises OSError."""
    with _named(target):
        number = os.open(target, os.O_WRONLY | os.O_APPEND | os.O_CREAT | getattr(os, "O_BINARY", 0), PRIVATE)
        with open(number, "wb", buffering=0) as file:
            found = os.fstat(number)
            if sys.platform != "win32" and stat.S_ISREG(found.st_mode) and found.st_mode & 0o077:
                with contextlib.suppress(PermissionError):  # another user's file: theirs to decide
                    os.fchmod(number, stat.S_IMODE(found.st_mode) & ~0o077)
            try:
                while data:
                    data = data[file.write(data) or 0 :]
            except OSError:
                if stat.S_ISREG(found.st_mode):
                    os.ftruncate(number, found.st_size)  # half a line would become part of the next one
                raise


def make_private_folder(folder: Path) -> None:
    """Create a folder that only this user can enter, or make an existing one so. Raises OSError."""
    folder.mkdir(mode=_PRIVATE_FOLDER, parents=True, exist_ok=True)
    if sys.platform != "win32" and folder.stat().st_mode & 0o077:
        with contextlib.suppress(PermissionError):
            folder.chmod(_PRIVATE_FOLDER)


def _before(target: Path) -> os.stat_result | None:
    """Return the status of the file at `target`, None if there is none or a broken link. Raises IsADirectoryError."""
    try:
        link = stat.S_ISLNK(target.lstat().st_mode)
        found = target.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None  # if the folder is missing too, creating the file reports it
    if link:
        return found if stat.S_ISREG(found.st_mode) else None
    if stat.S_ISDIR(found.st_mode):
        raise IsADirectoryError(21, "Is a directory", str(target))
    return found


def _keep_rights(number: int, before: os.stat_result) -> None:
    if sys.platform == "win32":
        return
    own = os.fstat(number)
    if (before.st_uid, before.st_gid) != (own.st_uid, own.st_gid):
        with contextlib.suppress(OSError):  # only root gives files away
            os.fchown(number, before.st_uid, before.st_gid)
    with contextlib.suppress(OSError):  # a file system without modes
        os.fchmod(number, stat.S_IMODE(before.st_mode))


@contextlib.contextmanager
def _named(target: Path, temporary: Path | None = None) -> Iterator[None]:
    """Make an OSError inside the block that names no file, or the temporary one, name `target`."""
    try:
        yield
    except OSError as error:
        if error.errno is None or error.filename not in (None, str(temporary)):
            raise
        raise OSError(error.errno, error.strerror, str(target)) from error
