"""Forks interpreters, and hands programs to them in place of starting new ones."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import _socket
import json
import os
import struct
from collections.abc import Callable, Mapping, Sequence
from typing import Union

from day6_core.virtual import ready
from day6_core.virtual.ready import unseen
from day6_core.virtual.surroundings import NEW, STARTUP, VARIABLE

START = os.path.join(os.path.dirname(__file__), "start.py")
_fork, _waitpid, _Socket = os.fork, os.waitpid, _socket.socket
HEADER = struct.Struct("=q")
Word = Union[str, bytes, "os.PathLike[str]"]
"""An argument or a path, as subprocess takes it."""
MOST_FDS = 64
_INTERPRETERS_OWN = ("LC_", "LD_", "PYTHON")
_ALSO = ("LANG", "LANGUAGE", "TZ", "MALLOC_ARENA_MAX")
"""Variables by which an interpreter and its C library begin. A program for which they are others gets a new interpreter."""
_LATER = ("PYTHONPATH", "PYTHONUNBUFFERED", "PYTHONUTF8")
"""But not these, which `becoming` reads; the last one changes nothing where text is UTF-8 anyway."""

_LONG = "room" * 2048
ROOM = "DAY6_ROOM"
"""A variable that only makes room for the words and variables of programs, which the system is to show."""


def _all_words(words: list[str]) -> tuple[list[str], list[str]]:
    return [], words


_environment: dict[str, str] = {}
join: Callable[[], None]
"""Has a process take part in the world of its environment; `follow.prepare` sets it."""
parted: Callable[[list[str]], tuple[list[str], list[str]]] = _all_words
"""Parts what starts a program from the program's own words; what the first ones say, `settle` does. Set by who knows both."""
settle: Callable[..., None]
known: frozenset[str] = frozenset()
"""Folders on PYTHONPATH in which no program has anything of its own."""


class Begun(BaseException):
    """In a fork: it begins to wait for a program. Goes through to `becoming`; nothing on its way may catch it."""

    def __init__(self, connection: _socket.socket) -> None:
        super().__init__()
        self.connection = connection


def command(module: str) -> list[str]:
    """Return what runs the main() of a module, in a process whose forks can become programs; with `environment`."""
    return [sys.executable, START, module, _LONG]


def environment(variables: Mapping[str, str]) -> dict[str, str]:
    """Return the variables for that. None of its programs has packages from the home of who starts it."""
    return {**variables, VARIABLE: NEW, "PYTHONHASHSEED": "0", "HOME": os.devnull, ROOM: _LONG}


def prepare(variables: Mapping[str, str]) -> None:
    """Let this process's forks get programs whose interpreters would begin by these variables."""
    _environment.update(variables)
    ready.wanted = 0


def fork(count: int) -> None:
    """Fork so many interpreters, and go on. Raises Begun in each of them; only for a process with one thread."""
    for _ in range(count):
        ours, theirs = _socket.socketpair()
        pid = _fork()
        if not pid:
            raise Begun(theirs)
        theirs.close()
        ready.waiting.append((pid, ours))
    unseen.give_back()


def start(
    argv: Sequence[Word], cwd: Word | None, env: Sequence[bytes] | None, fds: Mapping[int, int], *, new_session: bool
) -> int:
    """Have an interpreter become a program, whose descriptors are `fds` of ours, by its numbers; return the process number.

    0 if none is left or can: nothing has happened then.
    """
    before, words = parted([os.fsdecode(word) for word in argv])
    if words[0] != sys.executable or len(words) < 2 or words[1].startswith("-") or env is None or len(fds) > MOST_FDS:
        return 0
    folder = os.getcwd() if cwd is None else os.fsdecode(cwd)
    script = os.path.join(folder, words[1])
    variables = dict(each.split("=", 1) for each in map(os.fsdecode, env))
    if not (os.access(folder, os.X_OK) and os.access(script, os.R_OK) and _begins_alike(variables)):
        return 0
    if _has_namesakes(script, folder, variables):
        return 0
    ready.wanted = (ready.wanted or 0) + 1
    request = {
        "before": before, "argv": words[1:], "cwd": folder, "env": variables,
        "fds": list(fds), "new_session": new_session,
    }  # fmt: skip
    data = json.dumps(request).encode()
    rights = [(_socket.SOL_SOCKET, _socket.SCM_RIGHTS, struct.pack(f"{len(fds)}i", *fds.values()))]
    while ready.waiting:
        pid, connection = ready.waiting.popleft()
        try:
            _Socket.sendmsg(connection, [HEADER.pack(len(data))], rights)
            _Socket.sendall(connection, data)
            if _Socket.recv(connection, 1):
                return pid
        except OSError:
            pass  # as where nothing is received
        finally:
            connection.close()
        _waitpid(pid, 0)  # a program has killed it
    return 0


def _begins_alike(variables: Mapping[str, str]) -> bool:
    """Whether an interpreter with these variables would begin as these have, and in this world."""

    def of_interpreter(given: Mapping[str, str]) -> dict[str, str]:
        names = (name for name in given if name.startswith(_INTERPRETERS_OWN) or name in _ALSO)
        return {name: given[name] for name in names if name not in _LATER}

    if variables.get(VARIABLE) != os.environ[VARIABLE] or STARTUP not in variables.get("PYTHONPATH", "").split(
        os.pathsep
    ):
        return False
    if "PYTHONUTF8" in variables and sys.__stdout__ is not None and sys.__stdout__.encoding.lower() != "utf-8":
        return False
    return of_interpreter(variables) == of_interpreter(_environment)


def _has_namesakes(script: str, cwd: str, variables: Mapping[str, str]) -> bool:
    """Whether a script has modules of its own with names of such as are imported already."""
    taken = unseen.names()
    folders = {script_folder(script), *variables["PYTHONPATH"].split(os.pathsep)}
    for folder in folders - known - {STARTUP}:
        place = os.path.join(cwd, folder)
        try:
            names = os.listdir(place)
        except OSError:
            continue
        if any(name.partition(".")[0] in taken for name in names if "." in name or os.path.isdir(f"{place}/{name}")):
            return True
    return False


def script_folder(script: str) -> str:
    """Return the folder of a script, which is the first on its path."""
    return os.path.abspath(script) if os.path.isdir(script) else os.path.dirname(os.path.realpath(script))
