"""Measures and removes what is in a place. Links are never followed, and what is not ours stays."""

from __future__ import annotations

import contextlib
import os
import re
import stat
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

from day6_core.places import Place
from day6_core.ros.executables import is_executable_of_ours

_BY_CONTENTS: dict[str, Callable[[Path], bool]] = {
    "executables": is_executable_of_ours,
    "executables_begun": is_executable_of_ours,
}
"""Places whose files are known by what is in them."""


class Size(NamedTuple):
    """Bytes of files, and whether that is all: there was no time to look at more."""

    bytes: int
    whole: bool = True

    def __str__(self) -> str:
        for unit, size in (("GB", 1e9), ("MB", 1e6), ("kB", 1e3)):
            if self.bytes >= size:
                return f"{'' if self.whole else '>'}{self.bytes / size:.1f} {unit}"
        return f"{'' if self.whole else '>'}{self.bytes} B"


def size_of(path: Path, seconds: float = 10.0) -> Size:
    """Return what a file or a folder takes, as far as it can be seen in this time."""
    end = time.monotonic() + seconds
    found = 0
    for file in _inside(path):
        with contextlib.suppress(OSError):
            status = file.lstat()
            found += 0 if stat.S_ISDIR(status.st_mode) else status.st_size
        if time.monotonic() > end:
            return Size(found, False)
    return Size(found)


class Removed(NamedTuple):
    """What removing has left, and why."""

    foreign: list[Path]
    """Not ours."""
    failed: list[OSError]


def remove(place: Place, path: Path) -> Removed:
    """Remove what is ours at `path`, and every folder in which nothing is left; of the user's work all."""
    left = Removed([], [])
    for each in [path] if path.is_symlink() else _inside(path, upwards=True):
        is_folder = each.is_dir() and not each.is_symlink()
        if path.is_symlink() or not (is_folder or each == path or _is_ours(place, path, each)):
            left.foreign.append(each)
            continue
        try:
            if not is_folder:
                each.unlink(missing_ok=True)
            elif not os.listdir(each):
                each.rmdir()
        except OSError as error:
            left.failed.append(error)
    return left


def _is_ours(place: Place, base: Path, path: Path) -> bool:
    if (by_contents := _BY_CONTENTS.get(place.name)) is not None:
        return by_contents(path)
    if not place.files:
        return True
    named = re.fullmatch(place.files, path.relative_to(base).as_posix()) is not None
    return named and not path.is_symlink()  # day6-tui makes no links there


def _inside(path: Path, *, upwards: bool = False) -> Iterator[Path]:
    """Yield a path and all that is in it; `upwards`: a folder after what is inside. Links are not followed."""
    if path.is_symlink() or not path.is_dir():
        yield path
        return
    for folder, folders, files in os.walk(path, topdown=not upwards):
        links = [name for name in folders if os.path.islink(os.path.join(folder, name))]
        yield from (Path(folder, name) for name in [*files, *links])
        yield Path(folder)
