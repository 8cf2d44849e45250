"""How a world in virtual time begins, and what its processes find in their environment."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import cache
from itertools import count
from typing import NoReturn, Protocol

VARIABLE = "DAY6_TIME"
"""Names the folder of the world. NEW or PACED in a process that is to be the first of one, empty in one that is to be in none."""
NEW = "new"
PACED = "paced"
"""The new world is one at a pace: a person takes part."""

NOBODY = "nobody"
"""In place of what comes from outside: nobody is there to be told anything, either."""

_PREFIX = "day6-time-"
_OUTSIDE, _FIRST = "outside", "first"
"""Links in its folder, whose targets are no files."""
_AT_A_PACE = "paced"
"""A file in its folder."""
_LONGEST_PLACE = 36
"""Bytes of the folder in which worlds are made: their sockets have paths of 100 bytes at most."""
STARTUP = os.path.join(os.path.dirname(__file__), "startup")
"""The first folder on PYTHONPATH in such a world."""


class NotHere(OSError):
    """There is no virtual time on this system."""


@cache
def is_there() -> bool:
    """Return whether there is virtual time here: on Linux that says of a process how often it has run, and when it ends."""
    if sys.platform != "linux":
        return False
    try:
        os.close(os.pidfd_open(os.getpid()))
        with open("/proc/self/schedstat", encoding="ascii") as file:
            return file.read().split()[2:] != ["0"]
    except OSError:
        return False


def is_virtual() -> bool:
    """Return whether this process is in virtual time."""
    return bool(os.environ.get(VARIABLE))


def is_due(*, real_time: bool) -> bool:
    """Return whether a command that runs in virtual time where there is any has yet to begin anew for that."""
    return is_there() and not is_virtual() and not real_time


def environment(base: Mapping[str, str], world: str = "", *, paced: bool = False) -> dict[str, str]:
    """Return the variables for a program of Python that is the first of a new world, in which people take part if `paced`.

    `world` is its folder, if that is made.

    Raises:
        NotHere: on systems other than Linux.
    """
    if not is_there():
        raise NotHere
    env = dict(base)
    env[VARIABLE] = world or (PACED if paced else NEW)
    if world:
        env["DAY6_RUNTIME_DIR"] = world
    env["DAY6_LINK"] = "local"
    env.setdefault("PYTHONHASHSEED", "0")
    others = [each for each in env.get("PYTHONPATH", "").split(os.pathsep) if each not in ("", STARTUP)]
    env["PYTHONPATH"] = os.pathsep.join((STARTUP, *others))
    return env


def begin_anew(argv: list[str], base: Mapping[str, str], *, paced: bool = False) -> NoReturn:
    """Become a program of Python that is the first of a new world, in which people take part if `paced`.

    Raises:
        NotHere: on systems other than Linux.
        OSError: the program can't be started.
    """
    env = environment(base, paced=paced)
    sys.stdout.flush()
    os.execve(sys.executable, argv, env)


# -- for people ---------------------------------------------------------------------------------------------------------


class Pace(Protocol):
    """How fast time passes, for the threads of people."""

    speed: float
    """Seconds of the world in a real one; infinity is as fast as it can."""
    paused: bool
    replays: bool
    """Whether what was is played again: as fast as it can, whatever speed and pause are meanwhile."""
    waits: bool
    """Whether the world waits for the picture meanwhile."""
    people: Callable[[], None]
    """Has the calling thread live in real time."""
    sleep_until: Callable[[int], object]
    """Has the calling thread, which lives in the world's time, wait for a moment, without a look at a clock."""
    say: Callable[[str], None] | None
    """Says a sentence to the person. From any thread, also one that takes no part."""

    @property
    def now(self) -> int:
        """The time of the world, ns since it began."""

    def begin(self) -> None:
        """Let time pass from now on: all that was to be there when the world begins is."""

    def set_speed(self, speed: float) -> None:
        """Let time pass at this speed from now on."""

    def pause(self) -> None:
        """Let no time pass until `resume`."""

    def resume(self) -> None:
        """Let time pass again."""

    def step(self, seconds: float) -> None:
        """Let so much time pass while it is paused, at once."""


pace: Pace | None = None
"""Of this process's world, where it is the first one of a world in which people take part."""


def in_real_time() -> None:
    """The calling thread draws for a person or takes keys, and lives in real time, also where this process's is virtual."""
    if pace is not None:
        pace.people()


def leave() -> None:
    """This process, which is about to end without Python's own end, leaves nothing of its world."""
    if pace is not None:
        with suppress(OSError):  # a folder that a program of the world has locked
            remove(os.environ[VARIABLE])


# -- the folder of a world ---------------------------------------------------------------------------------------------


def own_world() -> str:
    """Return the folder of this process's world; made, if it is the first. Raises OSError."""
    world = os.environ[VARIABLE]
    if world in (NEW, PACED):
        kind, world = world, _make_folder()
        os.environ[VARIABLE] = os.environ["DAY6_RUNTIME_DIR"] = world
        if kind == PACED:
            os.close(os.open(os.path.join(world, _AT_A_PACE), os.O_CREAT, 0o600))
    return world


def socket_of(world: str) -> str:
    """Return the path of the coordinator's socket."""
    return os.path.join(world, "socket")


def is_first(world: str) -> bool:
    """Return whether this is the process that has the coordinator."""
    return _first_of(world) == str(os.getpid())


def is_paced(world: str) -> bool:
    """Return whether people take part in a world."""
    return os.path.exists(os.path.join(world, _AT_A_PACE))


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
            folder = os.path.join(path, name)
            (os.unlink if os.path.islink(folder) else os.rmdir)(folder)
    os.rmdir(world)


def _make_folder() -> str:
    """Make it, where there are none any more of worlds whose first process was killed."""
    place = os.environ.get("TMPDIR") or "/tmp"
    if len(os.fsencode(place)) > _LONGEST_PLACE:
        place = "/tmp"
    for name in os.listdir(place):
        world = os.path.join(place, name)
        if is_left(world) and not os.path.exists(f"/proc/{_first_of(name)}"):
            with suppress(OSError):
                remove(world)
    for number in count():
        world = os.path.join(place, f"{_PREFIX}{os.getpid()}-{number}")
        with suppress(FileExistsError):
            make_world(world, identity(0))
            break
    return world


def make_world(world: str, outside: str = NOBODY) -> None:
    """Make the folder of a world whose first process is this one. Raises OSError.

    What is read from a file of the identity `outside` comes from outside.
    """
    os.mkdir(world, 0o700)
    os.symlink(outside or "nothing", os.path.join(world, _OUTSIDE))
    os.symlink(str(os.getpid()), os.path.join(world, _FIRST))


def is_left(world: str) -> bool:
    """Return whether a folder is one of a world by its name, and nobody else can have put it there."""
    if not os.path.basename(world).startswith(_PREFIX):
        return False
    try:
        status = os.lstat(world)
    except OSError:
        return False
    return stat.S_ISDIR(status.st_mode) and sys.platform != "win32" and status.st_uid == os.getuid()


def _first_of(world: str) -> str:
    name = os.path.basename(world)
    if name.startswith(_PREFIX):
        return name.removeprefix(_PREFIX).partition("-")[0]
    try:
        return os.readlink(os.path.join(world, _FIRST))
    except OSError:
        return ""
