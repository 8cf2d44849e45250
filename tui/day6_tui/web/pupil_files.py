"""Puts files into the homes of pupils, and reads what is there.

A home is its pupil's, who may exchange a folder for a link at any moment, while the server perhaps is root. So each part of a
path is opened in the folder before it and never followed (`O_NOFOLLOW`), and what has another owner than the pupil is foreign.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import os
import sys
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from pathlib import PurePosixPath

from day6_core.classroom.handed import beside, put_beside
from day6_core.classroom.homes import Strange, read_file
from day6_core.isolation.cell import Cell
from day6_core.isolation.mode import Mode

DEEPEST = 16
"""Folders in a path, and in what is looked through."""

_FOLDER = os.O_RDONLY | getattr(os, "O_DIRECTORY", 0) | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_CLOEXEC", 0)
_MAKE = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_CLOEXEC", 0)


class BadPath(ValueError):
    """It leads out of a home, or is none."""


def parts_of(path: str) -> tuple[str, ...]:
    """The parts of a path below a home. Raises BadPath."""
    parts = PurePosixPath(path).parts
    if not parts or len(parts) > DEEPEST or any(part in ("/", "//", "..") or "\0" in part for part in parts):
        raise BadPath(path)
    try:
        os.fsencode(path)
    except UnicodeEncodeError:
        raise BadPath(path) from None
    return parts


@dataclass(frozen=True)
class Wanted:
    """What is taken of a home: the files in one of its folders, with `deep` those below it, too."""

    folder: str = ""
    """"": the home itself."""
    deep: bool = True
    endings: tuple[str, ...] = ()
    """Of the names of files that lie directly in it; none: all."""


@dataclass(frozen=True)
class Bounds:
    """What one look takes at most, and what it passes over."""

    files: int = 1000
    file_bytes: int = 5_000_000
    bytes: int = 15_000_000
    looks: int = 20_000
    """Names of files and folders that are looked at."""
    leaves_out: Collection[str] = ()
    """Names of folders."""


@dataclass
class Tree:
    """The contents of files by their paths in the home, and the paths of what was left out: links, devices, what is too much."""

    files: dict[str, bytes] = field(default_factory=dict)
    left_out: list[str] = field(default_factory=list)
    looked: int = 0
    size: int = 0


class PupilFiles:
    """The files of all pupils; `cell_of` names the place of each. What blocks is done in threads."""

    def __init__(self, mode: Mode, cell_of: Callable[[str], Cell]) -> None:
        self._mode = mode
        self._cell_of = cell_of

    async def put(self, name: str, path: str, data: bytes, *, renames: bool = True) -> str:
        """Put a file into a pupil's home, also before the pupil has come; return where it is.

        A file that is there is never changed: one with the same contents is the one, else a name beside it is taken or, without
        `renames`, FileExistsError raised. Raises BadPath, IsolationError, OSError.
        """
        return await asyncio.to_thread(self._put, name, path, data, renames)

    async def tree(self, name: str, wanted: Iterable[Wanted], bounds: Bounds) -> Tree:
        """Read many files at once; what is not there is nothing. Hidden files are none. Raises IsolationError, OSError."""
        return await asyncio.to_thread(self._tree, name, list(wanted), bounds)

    def _put(self, name: str, path: str, data: bytes, renames: bool) -> str:
        *above, last = parts_of(path)
        cell = self._cell_of(name)
        if not os.path.lexists(cell.home):
            self._mode.prepare(cell)
        if self._mode.disk_used(cell) + len(data) > cell.limits.disk:
            raise OSError(errno.EDQUOT, os.strerror(errno.EDQUOT), path)
        with _folder(cell, above, makes=True) as folder:
            found = put_beside(
                path,
                beside(last) if renames else [last],
                lambda each: write_file(cell, folder, each, data),
                lambda each: _has(cell, folder, each, data),
            )
        return "/".join([*above, found])

    def _tree(self, name: str, wanted: list[Wanted], bounds: Bounds) -> Tree:
        cell, found = self._cell_of(name), Tree()
        for each in wanted:
            above = parts_of(each.folder) if each.folder else ()
            with contextlib.suppress(FileNotFoundError, NotADirectoryError), _folder(cell, above) as folder:
                _gather(cell, folder, "".join(f"{part}/" for part in above), each, bounds, found, len(above))
        return found


def _gather(cell: Cell, folder: int, before: str, wanted: Wanted, bounds: Bounds, found: Tree, depth: int) -> None:
    """Read the files in an open folder, and below it."""
    with os.scandir(folder) as entries:
        some = islice(entries, max(0, bounds.looks - found.looked) + 1)
        names = sorted((entry.name, entry.is_dir(follow_symlinks=False)) for entry in some)
    for name, is_folder in names:
        found.looked += 1
        if found.looked > bounds.looks:
            found.left_out.append(before + name)
            return
        if name.startswith(".") or (is_folder and (not wanted.deep or name in bounds.leaves_out)):
            continue
        if not is_folder and wanted.endings and not name.endswith(wanted.endings):
            continue
        try:
            if is_folder:
                _gather_below(cell, folder, name, before, bounds, found, depth)
            elif len(found.files) >= bounds.files:
                found.left_out.append(before + name)
            else:
                data = _contents(cell, folder, name, min(bounds.file_bytes, bounds.bytes - found.size))
                found.files[before + name] = data
                found.size += len(data)
        except OSError:  # a link, a device, another's, too large, gone meanwhile
            found.left_out.append(before + name)


def _gather_below(cell: Cell, folder: int, name: str, before: str, bounds: Bounds, found: Tree, depth: int) -> None:
    if depth >= DEEPEST:
        found.left_out.append(f"{before}{name}/")
        return
    inner = os.open(name, _FOLDER, dir_fd=folder)
    try:
        _give(cell, inner, name, may=False)
        _gather(cell, inner, f"{before}{name}/", Wanted(), bounds, found, depth + 1)
    finally:
        os.close(inner)


def _server() -> int:
    """The user that this server is."""
    if sys.platform == "win32":  # which has no keepers
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    return os.geteuid()


def owner_of(cell: Cell) -> int:
    """The user whose the files of this home are."""
    return _server() if cell.uid is None else cell.uid


def _give_away(number: int, uid: int) -> None:
    if sys.platform != "win32":
        os.fchown(number, uid, uid)


def _foreign(path: str) -> PermissionError:
    return PermissionError(errno.EPERM, os.strerror(errno.EPERM), path)


@contextlib.contextmanager
def _folder(cell: Cell, parts: list[str] | tuple[str, ...], *, makes: bool = False) -> Iterator[int]:
    """Open a folder below the home, part by part, and make what is not there if asked for. Raises OSError."""
    folder = os.open(cell.home, _FOLDER)  # whose name no pupil can give to something else
    try:
        for part in parts:
            if makes:
                with contextlib.suppress(FileExistsError):
                    os.mkdir(part, 0o755, dir_fd=folder)
            inner = os.open(part, _FOLDER, dir_fd=folder)
            os.close(folder)
            folder = inner
            _give(cell, folder, part, may=makes)
        yield folder
    finally:
        os.close(folder)


def _give(cell: Cell, folder: int, part: str, *, may: bool) -> None:
    """Make a folder the pupil's that was made here: empty and the server's. Nobody's files are given away."""
    owner, found = owner_of(cell), os.fstat(folder).st_uid
    if found == owner:
        return
    if not may or found != _server() or os.listdir(folder):
        raise _foreign(part)
    _give_away(folder, owner)


def write_file(cell: Cell, folder: int, name: str, data: bytes, *, mode: int = 0o644, replaces: bool = False) -> None:
    """Write a pupil's file in an open folder, whole or not at all. Raises OSError; without `replaces`, FileExistsError."""
    temporary = f".day6-{os.urandom(6).hex()}"
    number = os.open(temporary, _MAKE, mode, dir_fd=folder)
    try:
        with open(number, "wb") as file:
            file.write(data)
            file.flush()
            if cell.uid is not None:
                _give_away(number, cell.uid)
            if replaces:  # what was is gone then
                os.fsync(number)
        if replaces:
            os.replace(temporary, name, src_dir_fd=folder, dst_dir_fd=folder)
        else:
            os.link(temporary, name, src_dir_fd=folder, dst_dir_fd=folder, follow_symlinks=False)
    finally:
        with contextlib.suppress(OSError):
            os.unlink(temporary, dir_fd=folder)


def _contents(cell: Cell, folder: int, name: str, most: int) -> bytes:
    """Read a pupil's file in an open folder. Raises OSError."""
    try:
        return read_file(folder, name, most, owner=owner_of(cell))
    except Strange as error:
        number = errno.EFBIG if str(error) == "large" else errno.EINVAL
        raise OSError(number, os.strerror(number), name) from None


def _has(cell: Cell, folder: int, name: str, data: bytes) -> bool:
    """Whether this file is there already."""
    try:
        return _contents(cell, folder, name, len(data)) == data
    except OSError:
        return False
