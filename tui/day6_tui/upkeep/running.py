"""What of day6-tui runs for this user: programs on a graph, kept desktops, servers of classes. Looking creates nothing."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from day6_core.link.file_lock import FileLock
from day6_core.link.paths import process_exists
from day6_core.places import PLACES

_PROGRAM = re.compile(r"p-[0-9a-f]+-(\d+)")
_LOCKS = {"desktop": re.compile(r"desktop-[0-9a-f]{8}\.lock"), "server": re.compile("lock")}
"""Files that are locked as long as something runs."""


class Running(NamedTuple):
    """A process of day6-tui."""

    kind: str
    """'program' (on a graph: an open desktop is one), 'desktop' (a kept one), 'server' (of a class)."""
    domain: str = ""
    pid: int = 0
    """0 if nobody knows."""


def running() -> list[Running]:
    """Return what runs now, without this process."""
    found: list[Running] = []
    for place in PLACES:
        if place.name in ("sockets", "users"):
            found += (each for base in place.found() for each in _in(base))
    return list(dict.fromkeys(found))


def _in(base: Path) -> Iterator[Running]:
    for folder, _, names in os.walk(base):
        for name in names:
            if (program := _PROGRAM.fullmatch(name)) is not None:
                pid = int(program[1])
                if pid != os.getpid() and process_exists(pid):
                    yield Running("program", os.path.basename(folder), pid)
            for kind, pattern in _LOCKS.items():
                if pattern.fullmatch(name) and _is_held(Path(folder, name)):
                    yield Running(kind)


def _is_held(path: Path) -> bool:
    """Return whether another process holds the lock of a file that exists."""
    if not path.is_file():
        return False
    lock = FileLock(path)
    try:
        return not lock.try_acquire()
    except OSError:
        return False
    finally:
        lock.release()
