"""The homes of a class as `day6-tui serve` keeps them below `--data`, read as what they are: other people's files.

Nothing in a home is believed to be what its name says. No link is followed, also not by a folder on the way; nothing is waited
for, as a pipe would want; nothing large is read. A home may change while it is read.
"""

from __future__ import annotations

import errno
import json
import os
import stat
import sys
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple
from zlib import crc32

HOMES, SERVER, BEFORE, ASSIGNMENTS, TOKENS = "homes", "server", "before", "assignments", "tokens.json"
"""In the folder of `--data`: the homes, what the server remembers, homes that were reset, collected work; in `server` who may."""

_LARGEST_TOKENS = 10_000_000
_LONGEST_FOLDER = 120
"""Bytes: a file system takes 255, and ours get something added."""
_FLAGS = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)
_FOLDER = _FLAGS | getattr(os, "O_DIRECTORY", 0)


class Strange(Exception):
    """A file that is not read: 'large', 'strange' (no file, but a link, a pipe …)."""


class PupilHome(NamedTuple):
    """A pupil of a class, and the home folder; there is none before the pupil has come."""

    name: str
    folder: Path


def same_name(name: str) -> str:
    """Two names with the same result are one pupil's."""
    return unicodedata.normalize("NFKC", name).casefold()


def folder_name(name: str) -> str:
    """The folder of a pupil's home: the name, where that is a plain file name, and different for different pupils."""
    key = same_name(name)
    plain = "".join(letter if letter.isalnum() or letter in "-_" else "-" for letter in key)
    if plain == key and len(plain.encode()) <= _LONGEST_FOLDER and not plain.startswith("-"):
        return plain
    return f"{plain.encode()[:_LONGEST_FOLDER].decode(errors='ignore').strip('-')}-{crc32(key.encode()):08x}"


def is_class(data: Path) -> bool:
    """Whether a server has kept a class here."""
    return (data / HOMES).is_dir()


def hidden_of(data: Path) -> list[Path]:
    """What no program of a pupil's may see while it is graded."""
    return [data / name for name in (HOMES, SERVER, BEFORE, ASSIGNMENTS)]


def homes_of(data: Path) -> list[PupilHome]:
    """All who have a home or may come in, by name; who may not come in any more is called as the folder is. Raises OSError."""
    names = {folder_name(name): name for name in _names(data / SERVER / TOKENS)}
    folders = names.keys() | {entry.name for entry in os.scandir(data / HOMES) if entry.is_dir(follow_symlinks=False)}
    found = (PupilHome(names.get(folder, folder), data / HOMES / folder) for folder in folders)
    return sorted(found, key=lambda each: same_name(each.name))


def _names(path: Path) -> list[str]:
    """The names in the server's file; none if it cannot be read: then the folders have to do."""
    try:
        with open(path, "rb") as file:
            found = json.loads(file.read(_LARGEST_TOKENS))
        return [name for each in found["tickets"] if isinstance(name := each["name"], str) and name]
    except (OSError, ValueError, TypeError, KeyError, RecursionError):
        return []


@contextmanager
def opened_folder(home: Path, *below: str) -> Iterator[int]:
    """Open a folder of a home; the number is for `dir_fd`. Raises OSError, also if a link is on the way."""
    if sys.platform == "win32":  # which has no such classes
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    number = os.open(home, _FOLDER)
    try:
        for name in below:
            inner = os.open(name, _FOLDER, dir_fd=number)
            os.close(number)
            number = inner
        yield number
    finally:
        os.close(number)


def read_file(folder: int, name: str, most: int, *, owner: int | None = None) -> bytes:
    """Read a file of an open folder, only this user's if there is an `owner`. Raises Strange, PermissionError, OSError."""
    if stat.S_ISLNK(os.stat(name, dir_fd=folder, follow_symlinks=False).st_mode):
        raise Strange("strange")
    number = os.open(name, _FLAGS, dir_fd=folder)
    try:
        found = os.fstat(number)
        if owner is not None and found.st_uid != owner:  # a link to another's file, where the system lets one be made
            raise PermissionError(errno.EPERM, os.strerror(errno.EPERM), name)
        if not stat.S_ISREG(found.st_mode):
            raise Strange("strange")
        with open(number, "rb", closefd=False) as file:
            data = b"" if found.st_size > most else file.read(most + 1)
    finally:
        os.close(number)
    if found.st_size > most or len(data) > most:
        raise Strange("large")
    return data
