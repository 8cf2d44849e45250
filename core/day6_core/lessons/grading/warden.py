"""The process around one judge: `python -I -m day6_core.lessons.grading.warden`, with a job as JSON on standard input.

It puts the judge behind its shield, watches time, processes and memory, and leaves nothing running. What the judge says goes
through to standard output, a line of JSON for each thing; the last line is ours and says how it ended.
"""

from __future__ import annotations

import json
import os
import secrets
import shutil
import signal
import sys
import time
from collections import deque
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.guardian import MARK
from day6_core.lessons.grading import shield
from day6_core.virtual import surroundings

assert not TYPE_CHECKING or sys.platform != "win32"  # `command.main` says so there

JUDGE = "day6_core.lessons.grading.judge"
_KEPT = ("LANG", "LC_ALL", "TZ", "LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH", "DAY6_WATCH")


def main() -> int:
    shield.end_with_parent()
    job = json.loads(sys.stdin.readline())
    work = Path(job["work"])
    try:
        job["archive"] = os.open(job["archive"], os.O_RDONLY | os.O_NONBLOCK)
        os.set_inheritable(job["archive"], True)
    except OSError:  # the judge says why
        job["hidden"] = []
    if job["user"] is not None:
        shield.give_up_root(job["user"], work)
    if job["shield"] != shield.Shield.NONE.value:
        status = _try_shielded(job, work)
        if status is not None:
            return status
    shield.hide()
    shield.adopt_orphans()
    mark = secrets.token_hex(8)
    told = _watched(job, work, mark, lambda: shield.followers(os.getpid(), mark))
    shield.end_all(os.getpid(), mark)
    shutil.rmtree(work, ignore_errors=True)
    _say(**told, shield=shield.Shield.NONE.value)
    return 0


def _try_shielded(job: dict[str, Any], work: Path) -> int | None:
    """Judge behind the shield; None where there is none: then a process that had tried could not go back, so another tries."""
    trial = os.fork()
    if trial:
        _, status = os.waitpid(trial, 0)
        code = os.waitstatus_to_exitcode(status)
        if code == _NO_SHIELD:
            return None
        if code < 0:
            _say(ended="killed", shield=shield.Shield.WHOLE.value)
        return 0
    shield.end_with_parent()
    try:
        inside = shield.enter(work, job["hidden"])
    except shield.Unshielded as reason:
        sys.stderr.write(f"{reason}\n")
        os._exit(_NO_SHIELD)
    shield.hide()
    if inside:
        shield.end_with_parent()  # once more: the new namespace has forgotten it
        _, status = os.waitpid(inside, 0)
        os._exit(0 if os.waitstatus_to_exitcode(status) == 0 else 1)
    _say(**_watched(job, work, "", shield.all_processes), shield=shield.Shield.WHOLE.value)
    os._exit(0)  # the first process inside: whatever still runs there ends with it


_NO_SHIELD = 77
STALL, MOST_STALLS = 0.02, 10_000
"""Seconds from which on waiting for the machine is noted, and how often at most."""


def _watched(job: dict[str, Any], work: Path, mark: str, processes: Any) -> dict[str, Any]:
    """Start the judge and wait for it; returns how it ended, and when this process had to wait for the machine, how long."""
    for name in ("home", "run", "tmp"):
        (work / name).mkdir(mode=0o700)
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        _become_judge(job, work, mark, reading, writing)
    os.close(reading)
    with os.fdopen(writing, "wb") as pipe:
        pipe.write(json.dumps(job).encode())
    stalls: deque[tuple[float, float]] = deque(maxlen=MOST_STALLS)

    def late(seconds: float) -> None:
        if seconds >= STALL:
            stalls.append((time.monotonic(), round(seconds, 3)))

    ended = shield.watch(child, float(job["seconds"]), processes, late)
    return {"ended": ended, "stalls": [] if job["virtual"] else list(stalls)}


def _become_judge(job: dict[str, Any], work: Path, mark: str, reading: int, writing: int) -> None:
    os.close(writing)
    os.dup2(reading, 0)
    os.setsid()
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    shield.limit(float(job["seconds"]))
    environment = {name: os.environ[name] for name in _KEPT if name in os.environ}
    environment.update(
        PATH=os.environ.get("PATH", os.defpath),
        HOME=str(work / "home"),
        TMPDIR=str(work / "tmp"),
        DAY6_RUNTIME_DIR=str(work / "run"),
        DAY6_MEMORY_LIMIT="1024",
        ROS_LOG_DIR=str(work / "tmp" / "log"),
    )
    if mark:
        environment[f"{MARK}_GRADE"] = mark
    environment.setdefault("LANG", "C.UTF-8")
    if job["virtual"]:
        surroundings.make_world(world := str(work / str(os.getpid())))
        environment = surroundings.environment(environment, world)
    os.chdir(work)
    os.execve(sys.executable, [sys.executable, "-I", "-m", JUDGE], environment)


def _say(**what: Any) -> None:
    sys.stdout.write(json.dumps(what) + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
