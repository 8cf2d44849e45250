"""System calls for paths that are longer than the system takes in one piece (4,096 bytes on Linux, 1,024 on macOS).

Trees can be deeper than that: a program makes its folders one in the other, an archive contains them. As GNU's tools do, such a
path is walked in pieces, each opened from the one before. Paths of ordinary length cost nothing.
"""

from __future__ import annotations

import os
import stat as kinds
import sys
from collections.abc import Iterator
from contextlib import contextmanager

LONGEST = 1000 if sys.platform == "darwin" else 4000
"""Bytes of a path that every system call takes."""

_BY_PIECES = os.open in os.supports_dir_fd and os.stat in os.supports_dir_fd
_FOLDER = os.O_RDONLY | getattr(os, "O_DIRECTORY", 0) | getattr(os, "O_CLOEXEC", 0)


@contextmanager
def _reaching(path: str | os.PathLike[str]) -> Iterator[tuple[str | bytes, int | None]]:
    """Give a path that is short enough, and the descriptor of the folder that it begins in. Raises OSError."""
    text = os.fspath(path)
    rest, folder = os.fsencode(text), None
    if len(rest) <= LONGEST or not _BY_PIECES:
        yield text, None
        return
    try:
        while len(rest) > LONGEST and (at := rest.rfind(b"/", 1, LONGEST)) > 0:
            inner = os.open(rest[:at], _FOLDER, dir_fd=folder)
            if folder is not None:
                os.close(folder)
            rest, folder = rest[at:].lstrip(b"/"), inner
        yield rest, folder
    finally:
        if folder is not None:
            os.close(folder)


def status(path: str | os.PathLike[str], *, follow: bool = False) -> os.stat_result:
    with _reaching(path) as (short, folder):
        return os.stat(short, dir_fd=folder, follow_symlinks=follow)


def mode(path: str | os.PathLike[str], *, follow: bool = False) -> int:
    """Return the type and mode of what is there, 0 if there is nothing that can be looked at."""
    try:
        return status(path, follow=follow).st_mode
    except (OSError, ValueError):
        return 0


def is_folder(path: str | os.PathLike[str], *, follow: bool = False) -> bool:
    return kinds.S_ISDIR(mode(path, follow=follow))


def is_link(path: str | os.PathLike[str]) -> bool:
    return kinds.S_ISLNK(mode(path))


def names_in(path: str | os.PathLike[str]) -> list[str]:
    with _reaching(path) as (short, folder):
        if folder is None:
            return os.listdir(path)
        inner = os.open(short, _FOLDER, dir_fd=folder)
        try:
            return os.listdir(inner)
        finally:
            os.close(inner)


def open_file(path: str | os.PathLike[str], flags: int, file_mode: int = 0o777) -> int:
    with _reaching(path) as (short, folder):
        return os.open(short, flags, file_mode, dir_fd=folder)


def make_folder(path: str | os.PathLike[str], folder_mode: int = 0o777) -> None:
    with _reaching(path) as (short, folder):
        os.mkdir(short, folder_mode, dir_fd=folder)


def remove(path: str | os.PathLike[str], *, folder: bool) -> None:
    """Remove a file or an empty folder."""
    with _reaching(path) as (short, above):
        (os.rmdir if folder else os.unlink)(short, dir_fd=above)


def rename(path: str | os.PathLike[str], goal: str | os.PathLike[str]) -> None:
    with _reaching(path) as (short, folder), _reaching(goal) as (short_goal, goals_folder):
        os.replace(short, short_goal, src_dir_fd=folder, dst_dir_fd=goals_folder)


def target_of(path: str | os.PathLike[str]) -> str:
    with _reaching(path) as (short, folder):
        return os.readlink(os.fsdecode(short), dir_fd=folder)


def make_link(target: str, path: str | os.PathLike[str]) -> None:
    with _reaching(path) as (short, folder):
        os.symlink(target, short, dir_fd=folder)


def set_mode(path: str | os.PathLike[str], file_mode: int) -> None:
    with _reaching(path) as (short, folder):
        os.chmod(short, file_mode, dir_fd=folder)


def set_times(path: str | os.PathLike[str], found: os.stat_result) -> None:
    with _reaching(path) as (short, folder):
        os.utime(short, ns=(found.st_atime_ns, found.st_mtime_ns), dir_fd=folder, follow_symlinks=False)
