"""How a world in virtual time begins, and what its processes find in their environment."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import NoReturn

VARIABLE = "DAY6_TIME"
"""Names the folder of the world. Empty in a process that is to be no part of it."""

_PREFIX = "day6-time-"
_OUTSIDE = "outside"
_STARTUP = Path(__file__).with_name("startup")


class NotHere(OSError):
    """There is no virtual time on this system."""


def is_virtual() -> bool:
    """Return whether this process is in virtual time."""
    return bool(os.environ.get(VARIABLE))


def own_world() -> str:
    """Return the folder of this process's world. Raises KeyError if it is in real time."""
    return os.environ[VARIABLE]


def socket_of(world: str) -> str:
    """Return the path of the coordinator's socket."""
    return os.path.join(world, "socket")


def is_first(world: str) -> bool:
    """Return whether this is the process that has the coordinator."""
    return _first_of(world) == str(os.getpid())


def _first_of(world: str) -> str:
    return os.path.basename(world).removeprefix(_PREFIX).partition("-")[0]


def environment(base: Mapping[str, str]) -> dict[str, str]:
    """Return the variables with which a program that this process becomes (`os.execve`) is the first of a new world.

    Raises:
        NotHere: on systems other than Linux.
        OSError: there is no place for its folder.
    """
    if sys.platform != "linux":
        raise NotHere
    import tempfile

    _clear_up(Path(tempfile.gettempdir()))
    world = tempfile.mkdtemp(prefix=f"{_PREFIX}{os.getpid()}-")
    os.symlink(identity(0) or "nothing", os.path.join(world, _OUTSIDE))
    env = dict(base)
    env[VARIABLE] = env["DAY6_RUNTIME_DIR"] = world
    env["DAY6_LINK"] = "local"
    env.setdefault("PYTHONHASHSEED", "0")
    env["PYTHONPATH"] = os.pathsep.join(filter(None, (str(_STARTUP), env.get("PYTHONPATH"))))
    return env


def _clear_up(temporary: Path) -> None:
    """Remove the folders of worlds whose first process was killed."""
    if sys.platform == "win32":
        return
    import shutil

    for folder in temporary.glob(f"{_PREFIX}*"):
        pid = _first_of(folder.name)
        with suppress(OSError):
            if folder.lstat().st_uid == os.getuid() and pid.isdecimal() and not Path("/proc", pid).exists():
                shutil.rmtree(folder, ignore_errors=True)


def begin_anew(argv: list[str], base: Mapping[str, str]) -> NoReturn:
    """Become a program that is the first of a new world.

    Raises:
        NotHere: on systems other than Linux.
        OSError: there is no place for the world's folder, or the program can't be started.
    """
    env = environment(base)
    sys.stdout.flush()
    os.execve(sys.executable, argv, env)


def identity(fd: int) -> str:
    """Return what tells the file of a descriptor from all others; '' if it is none."""
    try:
        found = os.fstat(fd)
    except OSError:
        return ""
    return f"{found.st_dev}:{found.st_ino}"


@cache
def outside() -> str:
    """Return the identity of the standard input that the world was given: what comes from there comes from outside."""
    return os.readlink(os.path.join(own_world(), _OUTSIDE))
