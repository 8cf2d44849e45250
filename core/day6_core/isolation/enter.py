"""Goes into a cell and becomes a program there: `python -I -m day6_core.isolation.enter MARK PLAN -- PROGRAM ARG…`.

It runs before anything of the pupil's does, with the server's rights, and gives them up in the order in which that is possible:
control groups, limits, user, new privileges, folders. With `supervise` it stays, outside the cell's restrictions, adopts whatever
the pupil's programs leave behind and kills it when the first of them has ended.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import signal
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from types import FrameType
from typing import Any, NoReturn

from day6_core.isolation import landlock, left
from day6_core.isolation.cell import Cell
from day6_core.reason import named_reason

_PR_SET_DUMPABLE = 4
_PR_SET_CHILD_SUBREAPER = 36
_PR_SET_NO_NEW_PRIVS = 38

KEPT_VARIABLES = (
    *("LANG", "LANGUAGE", "LC_ALL", "LC_CTYPE", "LC_MESSAGES", "TZ", "PATH", "TERM", "COLORTERM", "TERM_PROGRAM"),
    *("COLUMNS", "LINES", "NO_COLOR", "PYTHONUTF8", "PYTHONDONTWRITEBYTECODE", "ROS_DOMAIN_ID"),
)
"""Of the server's environment a pupil sees these, and those that begin with DAY6_, nothing else."""


@dataclass(frozen=True)
class SandboxPlan:
    """What to do on the way in. Everything is optional; on macOS and Windows only `environment` and `folder` are done."""

    folder: str
    environment: dict[str, str]
    uid: int | None = None
    groups: list[str] = field(default_factory=list)
    """The files `cgroup.procs` of the control groups to join."""
    limits: dict[str, int] = field(default_factory=dict)
    """Names of the `resource` module, without RLIMIT_."""
    nice: int = 0
    readable: list[str] = field(default_factory=list)
    """With `writable`: what Landlock leaves of the files; both empty: all."""
    writable: list[str] = field(default_factory=list)
    scoped: bool = False
    """Whether signals and abstract sockets stay inside, where Landlock can do that."""
    supervise: bool = False
    descriptors: list[int] = field(default_factory=list)
    """What stays open besides 0, 1 and 2."""


def command(cell: Cell, plan: SandboxPlan, argv: list[str]) -> list[str]:
    """Return the command line that starts `argv` by this plan."""
    module = "day6_core.isolation.enter"
    return [sys.executable, "-I", "-m", module, cell.mark, json.dumps(filled(plan), sort_keys=True), "--", *argv]


def filled(plan: SandboxPlan) -> dict[str, Any]:
    """Return what the plan says, without what it leaves as it is."""
    return {name: value for name, value in asdict(plan).items() if value not in (None, [], {}, 0, False)}


def main(words: list[str]) -> int:
    """Enter; returns only with `supervise` or after an error."""
    _mark, plan, _, *argv = words
    try:
        return enter(SandboxPlan(**json.loads(plan)), argv)
    except OSError as error:
        print(f"day6-tui: {named_reason(error)}", file=sys.stderr)
        return 126


def _execute(argv: list[str], environment: dict[str, str]) -> NoReturn:
    os.execvpe(argv[0], argv, environment)


def enter(
    plan: SandboxPlan, argv: list[str], become: Callable[[list[str], dict[str, str]], NoReturn] = _execute
) -> int:
    """Do what the plan says and become `argv`. Raises OSError."""
    environment = _environment(plan)
    if sys.platform == "linux":
        close_others(plan.descriptors)
        for path in plan.groups:
            with open(path, "w", encoding="ascii") as file:
                file.write("0")
        os.umask(0o077)
        if plan.nice:
            os.nice(plan.nice)
        if plan.supervise and (status := _supervise()) is not None:
            return status
        _limit(plan.limits)
        if plan.uid is not None:
            _become(plan.uid)
        landlock.prctl(_PR_SET_NO_NEW_PRIVS, 1)
        if plan.readable or plan.writable or plan.scoped:
            landlock.restrict(plan.readable, plan.writable, scoped=plan.scoped)
        landlock.prctl(_PR_SET_DUMPABLE, 1)  # as a new program is: what /proc has of it is its own
    os.chdir(plan.folder)
    become(argv, environment)


def _environment(plan: SandboxPlan) -> dict[str, str]:
    kept = {name: value for name, value in os.environ.items() if name in KEPT_VARIABLES or name.startswith("DAY6_")}
    return {**kept, **plan.environment}


def close_others(descriptors: list[int]) -> None:
    """Close all but these and 0, 1 and 2."""
    for name in os.listdir("/proc/self/fd"):
        number = int(name)
        if number > 2 and number not in descriptors:
            with contextlib.suppress(OSError):  # the one that lists them
                os.close(number)


def _limit(limits: dict[str, int]) -> None:
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    import resource

    for name, value in {"CORE": 0, **limits}.items():
        number = getattr(resource, f"RLIMIT_{name}")
        most = resource.getrlimit(number)[1]
        value = value if most == resource.RLIM_INFINITY else min(value, most)
        resource.setrlimit(number, (value, value))


def _become(uid: int) -> None:
    """Be this user, for good, in the group of the same number and in no other; the terminal becomes his."""
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    for number in (0, 1, 2):
        if os.isatty(number):
            os.fchown(number, uid, uid)
            os.fchmod(number, 0o600)
    os.setgroups([])
    os.setresgid(uid, uid, uid)
    os.setresuid(uid, uid, uid)


def _supervise() -> int | None:
    """In the child: return None. In the parent: wait for it, end what it left, and return its exit status."""
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    landlock.prctl(_PR_SET_CHILD_SUBREAPER, 1)
    child = os.fork()
    if child == 0:
        return None
    os.chdir("/")

    def hand_on(number: int, _frame: FrameType | None) -> None:
        if number == signal.SIGTERM:  # from the server: it wants the end now
            left.end_descendants(os.getpid())
        with contextlib.suppress(ProcessLookupError):
            os.kill(child, number)

    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, hand_on)
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGTSTP, signal.SIGTTOU):
        signal.signal(number, signal.SIG_IGN)
    status = 0
    while True:
        pid, ended = os.waitpid(-1, 0)
        if pid == child:
            status = os.waitstatus_to_exitcode(ended)
            break
    left.end_descendants(os.getpid())
    return status if status >= 0 else 128 - status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
