"""The process around one judge after the other: `python -I -m day6_core.lessons.grading.warden`, with jobs on standard input.

Standard input is a socket, a job a line of JSON that programs may know, with the descriptor of a file of what only the judge is
to know. For each job, a child puts the judge behind its shield, watches time, processes and memory, and leaves nothing running.
What the judge says goes through to standard output, a line of JSON for each thing; then comes a line of ours which says how it
ended, and OVER.

In virtual time, `virtual.ready` runs it. The judge is forked, too, from a process that has everything imported, and so are the
interpreters of the submission's programs: from the judge, before it reads its file, which nobody has read before. This process
lives by the time of no world: what it and its children need of the real one is taken from Python here and in `shield`, before it
is replaced.
"""

from __future__ import annotations

import json
import os
import secrets
import shutil
import signal
import socket
import struct
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.guardian import MARK
from day6_core.lessons.grading import shield
from day6_core.lessons.grading.limits import OVER
from day6_core.system.processes import own_memory
from day6_core.virtual import surroundings

assert not TYPE_CHECKING or sys.platform != "win32"  # `command.main` says so there

JUDGE = "day6_core.lessons.grading.judge"
HELD_SECONDS = 5.0
"""For how long the programs of a submission may hold its time, by computing and by real waits; then it goes on beside them."""

_KEPT = ("LANG", "LC_ALL", "TZ", "LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH", "DAY6_WATCH")
_Socket, _recvmsg, _monotonic = socket.socket, socket.socket.recvmsg, time.monotonic
_INT = struct.Struct("i")

Begin = Callable[[dict[str, Any]], None]
"""Judges by a job, in a child; None where that is a program of its own."""


def main() -> int:
    shield.end_with_parent()
    shield.hide()
    begin = _beginner() if surroundings.is_virtual() else None
    for line, secret in _jobs():
        child = shield.fork()
        if not child:
            os.dup2(os.open(os.devnull, os.O_RDWR), 0)
            _serve({**json.loads(line), "secret": secret}, begin)
            os._exit(0)
        os.close(secret)
        shield.waitpid(child, 0)
        os.write(1, b"\n" + OVER)
    return 0


def _jobs() -> Iterator[tuple[bytes, int]]:
    """The jobs that come, one after the other, each with the descriptor of the file."""
    line, secret = b"", -1
    with _Socket(fileno=os.dup(0)) as jobs:
        while True:
            data, sent, *_ = _recvmsg(jobs, 1 << 16, socket.CMSG_SPACE(_INT.size))
            if not data:
                return
            line += data
            if sent:
                (secret,) = _INT.unpack(sent[0][2])
            if line.endswith(b"\n"):
                yield line, secret
                line = b""


def _beginner() -> Begin:
    """Prepare this process for virtual time; return what judges then."""
    begin_world = prepare()
    from day6_core.lessons.grading.judge import judge

    return lambda job: judge(job, lambda: begin_world(HELD_SECONDS))


def prepare() -> Callable[[float], None]:
    """Import everything that jobs take, for virtual time; return what `follow.prepare` does."""
    from day6_core.ros.environment import python_folders
    from day6_core.shell.process import prepared
    from day6_core.virtual import follow
    from day6_core.virtual.ready import forks, unseen
    from day6_core.virtual.ready.shown import show

    begin_world = follow.prepare()
    forks.parted, forks.settle, forks.known = prepared.parted, prepared.settle, frozenset(python_folders())
    from day6_core.lessons.grading import judge

    judge.prepare()
    show(["day6-tui", "grade"], {})
    unseen.hide()
    return begin_world


def _serve(job: dict[str, Any], begin: Begin | None) -> None:
    """Judge one submission."""
    shield.end_with_parent()
    work = Path(job["work"])
    try:
        job["archive"] = os.open(job["archive"], os.O_RDONLY | os.O_NONBLOCK)
        os.set_inheritable(job["archive"], True)
    except OSError:  # the judge says why
        job["hidden"] = []
    if job["user"] is not None:
        shield.give_up_root(job["user"], work)
    if job["shield"] != shield.Shield.NONE.value and _try_shielded(job, work, begin):
        return
    shield.hide()
    shield.adopt_orphans()
    mark = secrets.token_hex(8)
    told = _watched(job, work, mark, lambda: shield.followers(os.getpid(), mark), begin)
    shield.end_all(os.getpid(), mark)
    shutil.rmtree(work, ignore_errors=True)
    _say(**told, shield=shield.Shield.NONE.value)


def _try_shielded(job: dict[str, Any], work: Path, begin: Begin | None) -> bool:
    """Judge behind the shield; False where there is none: then a process that had tried could not go back, so another tries."""
    trial = shield.fork()
    if trial:
        _, status = shield.waitpid(trial, 0)
        code = os.waitstatus_to_exitcode(status)
        if code < 0:
            _say(ended="killed", shield=shield.Shield.WHOLE.value)
        return code != _NO_SHIELD
    shield.end_with_parent()
    shield.hide(False)  # or its namespace would be nobody's
    try:
        inside = shield.enter(work, job["hidden"])
    except shield.Unshielded as reason:
        sys.stderr.write(f"{reason}\n")
        os._exit(_NO_SHIELD)
    shield.hide()
    if inside:
        shield.end_with_parent()  # once more: the new namespace has forgotten it
        _, status = shield.waitpid(inside, 0)
        os._exit(0 if os.waitstatus_to_exitcode(status) == 0 else 1)
    _say(**_watched(job, work, "", shield.all_processes, begin), shield=shield.Shield.WHOLE.value)
    os._exit(0)  # the first process inside: whatever still runs there ends with it


_NO_SHIELD = 77
STALL, MOST_STALLS = 0.02, 10_000
"""Seconds from which on waiting for the machine is noted, and how often at most."""


def _watched(job: dict[str, Any], work: Path, mark: str, processes: Any, begin: Begin | None) -> dict[str, Any]:
    """Start the judge and wait for it; returns how it ended, and when this process had to wait for the machine, how long."""
    for name in ("home", "run", "tmp"):
        (work / name).mkdir(mode=0o700)
    child = shield.fork()
    if not child:
        _become_judge(job, work, mark, begin)
    stalls: deque[tuple[float, float]] = deque(maxlen=MOST_STALLS)

    def late(seconds: float) -> None:
        if seconds >= STALL and begin is None:
            stalls.append((_monotonic(), round(seconds, 3)))

    inherited = own_memory([os.getpid()]) * (1 + job["programs"]) if begin is not None else 0
    ended = shield.watch(
        child, float(job["seconds"]), processes, late, own_seconds=begin is not None, inherited=inherited
    )
    return {"ended": ended, "stalls": list(stalls)}


def _become_judge(job: dict[str, Any], work: Path, mark: str, begin: Begin | None) -> None:
    shield.end_with_parent()
    os.setsid()
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    shield.limit(float(job["seconds"]))
    variables = environment()
    variables.update(
        HOME=str(work / "home"),
        TMPDIR=str(work / "tmp"),
        DAY6_RUNTIME_DIR=str(work / "run"),
        ROS_LOG_DIR=str(work / "tmp" / "log"),
    )
    if mark:
        variables[f"{MARK}_GRADE"] = mark
    os.chdir(work)
    if begin is not None:
        from day6_core.virtual.ready import forks

        surroundings.make_world(world := str(work / "w"))
        os.environ.update(surroundings.environment(variables, world))
        forks.fork(job["programs"])
        begin(_whole(job))
        os._exit(0)
    with open(work / "tmp" / "job", "w+b") as file:
        file.write(json.dumps(_whole(job)).encode())
        file.seek(0)
        os.dup2(file.fileno(), 0)
    os.unlink(work / "tmp" / "job")
    os.execve(sys.executable, [sys.executable, "-I", "-m", JUDGE], variables)


def _whole(job: dict[str, Any]) -> dict[str, Any]:
    """A job with what only the judge may know."""
    with os.fdopen(job.pop("secret"), "rb") as file:
        return {**job, **json.loads(file.read())}


def environment() -> dict[str, str]:
    """The variables of every judge."""
    environment = {name: os.environ[name] for name in _KEPT if name in os.environ}
    environment.update(PATH=os.environ.get("PATH", os.defpath), DAY6_MEMORY_LIMIT="1024")
    return {"LANG": "C.UTF-8", **environment}


def _say(**what: Any) -> None:
    sys.stdout.write(json.dumps(what) + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
