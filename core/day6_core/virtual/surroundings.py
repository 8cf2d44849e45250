"""How a world in virtual time begins, and what its processes find in their environment."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from itertools import count
from typing import NoReturn

VARIABLE = "DAY6_TIME"
"""Names the folder of the world; NEW in a process that is to be the first of one, and empty in one that is to be in none."""
NEW = "new"

NOBODY = "nobody"
"""In place of what comes from outside: nobody is there to be told anything, either."""

_PREFIX = "day6-time-"
_OUTSIDE = "outside"
_LONGEST_PLACE = 36
"""Bytes of the folder in which worlds are made: their sockets have paths of 100 bytes at most."""
_STARTUP = os.path.join(os.path.dirname(__file__), "startup")


class NotHere(OSError):
    """There is no virtual time on this system."""


@cache
def is_there() -> bool:
    """Return whether there is virtual time on this system: Linux that says of a process how often it has run."""
    try:
        with open("/proc/self/schedstat", encoding="ascii") as file:
            return sys.platform == "linux" and file.read().split()[2:] != ["0"]
    except OSError:
        return False


def is_virtual() -> bool:
    """Return whether this process is in virtual time."""
    return bool(os.environ.get(VARIABLE))


def is_due(*, real_time: bool) -> bool:
    """Return whether a command that runs in virtual time where there is any has yet to begin anew for that."""
    return is_there() and not is_virtual() and not real_time


def environment(base: Mapping[str, str], world: str = "") -> dict[str, str]:
    """Return the variables for a program of Python that is the first of a new world: `world` is its folder, if that is made.

    Raises:
        NotHere: on systems other than Linux.
    """
    if not is_there():
        raise NotHere
    env = dict(base)
    env[VARIABLE] = world or NEW
    if world:
        env["DAY6_RUNTIME_DIR"] = world
    env["DAY6_LINK"] = "local"
    env.setdefault("PYTHONHASHSEED", "0")
    env["PYTHONPATH"] = os.pathsep.join(filter(None, (_STARTUP, env.get("PYTHONPATH"))))
    return env


def begin_anew(argv: list[str], base: Mapping[str, str]) -> NoReturn:
    """Become a program of Python that is the first of a new world.

    Raises:
        NotHere: on systems other than Linux.
        OSError: the program can't be started.
    """
    env = environment(base)
    sys.stdout.flush()
    os.execve(sys.executable, argv, env)


# -- the folder of a world ---------------------------------------------------------------------------------------------


def own_world() -> str:
    """Return the folder of this process's world; made, if it is the first. Raises OSError."""
    world = os.environ[VARIABLE]
    if world == NEW:
        world = os.environ[VARIABLE] = os.environ["DAY6_RUNTIME_DIR"] = _make_folder()
    return world


def socket_of(world: str) -> str:
    """Return the path of the coordinator's socket."""
    return os.path.join(world, "socket")


def is_first(world: str) -> bool:
    """Return whether this is the process that has the coordinator."""
    return _first_of(world) == str(os.getpid())


@cache
def outside() -> str:
    """Return the identity of the standard input that the world was given: what comes from there comes from outside."""
    return os.readlink(os.path.join(os.environ[VARIABLE], _OUTSIDE))


def identity(file: int | str) -> str:
    """Return what tells the file of a descriptor or path from all others; '' if it is none."""
    try:
        found = os.stat(file)
    except OSError:
        return ""
    return f"{found.st_dev}:{found.st_ino}"


def remove(world: str) -> None:
    """Remove the folder of a world, at its end. Nothing is imported for it; see `follow`."""
    for path, folders, files in os.walk(world, topdown=False):
        for name in files:
            os.unlink(os.path.join(path, name))
        for name in folders:
            os.rmdir(os.path.join(path, name))
    os.rmdir(world)


def _make_folder() -> str:
    """Make it, where there are none any more of worlds whose first process was killed."""
    place = os.environ.get("TMPDIR") or "/tmp"
    if len(os.fsencode(place)) > _LONGEST_PLACE:
        place = "/tmp"
    for name in os.listdir(place):
        if name.startswith(_PREFIX) and not os.path.exists(f"/proc/{_first_of(name)}"):
            with suppress(OSError):
                _remove_own(os.path.join(place, name))
    for number in count():
        world = os.path.join(place, f"{_PREFIX}{os.getpid()}-{number}")
        with suppress(FileExistsError):
            make_world(world, identity(0))
            break
    return world


def make_world(world: str, outside: str = NOBODY) -> None:
    """Make the folder of a world; its name begins with the number of the first process, and perhaps a prefix. Raises OSError.

    What is read from a file of the identity `outside` comes from outside.
    """
    os.mkdir(world, 0o700)
    os.symlink(outside or "nothing", os.path.join(world, _OUTSIDE))


def _remove_own(world: str) -> None:
    """Remove a folder that nobody else can have put there: one of this user's, and no link."""
    status = os.lstat(world)
    if stat.S_ISDIR(status.st_mode) and sys.platform != "win32" and status.st_uid == os.getuid():
        remove(world)


def _first_of(world: str) -> str:
    return os.path.basename(world).removeprefix(_PREFIX).partition("-")[0]
