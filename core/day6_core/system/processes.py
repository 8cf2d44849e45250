"""The processes of this machine: from /proc where there is one, else by `ps` (macOS).

What `ps` shows of an environment is what the kernel lets out. macOS keeps that of Apple's own programs (/bin/sleep) to itself:
xnu, bsd/kern/kern_sysctl.c, sysctl_procargsx.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import Collection, Iterable, Iterator
from typing import NamedTuple

PROC = "/proc"
"""Where Linux shows its processes; tests name a folder that isn't there."""


class ProcessEntry(NamedTuple):
    """A line of the process table."""

    pid: int
    parent: int
    is_dead: bool
    """It has ended, and its parent has not asked."""
    group: int = 0
    resident: int = 0
    """Bytes in memory, also of what it shares with others."""


def has_proc() -> bool:
    """Whether the system shows its processes as files."""
    return os.path.exists(f"{PROC}/self/stat")


def stat_fields(process: int | str) -> list[bytes]:
    """Return what /proc/…/stat says after the name, beginning with the state (proc(5)). Raises OSError."""
    with open(f"{PROC}/{process}/stat", "rb") as file:
        return file.read().rpartition(b")")[2].split()  # the name may hold anything


def processes() -> list[ProcessEntry]:
    """Return the process table; empty where nobody shows it."""
    return list(_shown_in_proc() if has_proc() else _listed())


def _shown_in_proc() -> Iterator[ProcessEntry]:
    if sys.platform == "win32":
        return
    page = os.sysconf("SC_PAGE_SIZE")
    for pid in _numbers():
        with contextlib.suppress(OSError, ValueError, IndexError):
            state, parent, group, *others = stat_fields(pid)
            yield ProcessEntry(pid, int(parent), state in (b"Z", b"X"), int(group), int(others[18]) * page)


def _numbers() -> list[int]:
    return [int(name) for name in os.listdir(PROC) if name.isdigit()]


def _listed() -> Iterator[ProcessEntry]:
    for pid, line in _ps("-axo", "pid=,ppid=,pgid=,rss=,stat="):
        parent, group, kilobytes, state = line.split()
        yield ProcessEntry(pid, int(parent), state.startswith("Z"), int(group), int(kilobytes) << 10)


def _ps(*words: str) -> Iterator[tuple[int, str]]:
    """Yield the lines of `ps`, each as the number of a process and what follows; nothing where there is no `ps`."""
    try:
        with subprocess.Popen(["ps", *words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as asked:
            lines = asked.communicate()[0].decode(errors="replace").splitlines()
    except OSError:
        return
    for number, _, rest in (line.strip().partition(" ") for line in lines):
        if number.isdigit() and int(number) != asked.pid:
            yield int(number), rest


def family(table: Collection[ProcessEntry], roots: Collection[int], *, dead: bool = False) -> list[int]:
    """Return the processes below some others, each once; a root only if it is below another, the `dead` only if asked for."""
    children: dict[int, list[int]] = {}
    for each in table:
        children.setdefault(each.parent, []).append(each.pid)
    found: dict[int, None] = {}
    waiting = list(roots)
    while waiting:
        below = [pid for pid in children.get(waiting.pop(), []) if pid not in found]
        found |= dict.fromkeys(below)
        waiting += below
    left_out = set() if dead else {each.pid for each in table if each.is_dead}
    return [pid for pid in found if pid not in left_out]


def descendants(*roots: int, dead: bool = False) -> list[int]:
    """Return the family of some processes as it is now."""
    return family(processes(), roots, dead=dead)


def marked(assignment: str) -> list[int]:
    """Return the processes that were started with this variable, `NAME=value`; `value` has no spaces."""
    if not has_proc():
        return [pid for pid, line in _ps(*_WITH_ENVIRONMENT) if assignment in line.split()]
    wanted, found = assignment.encode(), []
    for pid in _numbers():
        with contextlib.suppress(OSError), open(f"{PROC}/{pid}/environ", "rb") as file:  # another user's, or gone
            if wanted in file.read().split(b"\0"):
                found.append(pid)
    return found


_WITH_ENVIRONMENT = ("-axEww" if sys.platform == "darwin" else "axeww", "-o", "pid=,command=")
"""All processes with their environments; the letter for these is not the same for macOS's ps and Linux's."""

SHELL_OF_PROC = """\
marked() { grep -ls "$mark" /proc/[0-9]*/environ 2>/dev/null | while IFS=/ read -r _ _ pid _; do echo "$pid"; done; }
"""
SHELL_OF_PS = f"""\
marked() {{
  ps {" ".join(_WITH_ENVIRONMENT)} 2>/dev/null |
    while read -r pid line; do case " $line" in *" $mark"*) echo "$pid" ;; esac; done
}}
"""


def shell_marked() -> str:
    """Return a function of sh that prints the processes which have a variable beginning with `$mark`."""
    return SHELL_OF_PROC if has_proc() else SHELL_OF_PS


def own_memory(pids: Iterable[int]) -> int:
    """Return the bytes that these processes have in memory and do not share with a file (without /proc: all of them)."""
    if not has_proc():
        wanted = set(pids)
        return sum(each.resident for each in _listed() if each.pid in wanted)
    return sum(map(_own_memory, pids))


def divided_memory(pids: Iterable[int]) -> int:
    """The same, but what processes share after a fork is divided among them, where the system says how much that is.

    Asking takes a hundred times as long.
    """
    return sum(_divided_memory(pid) for pid in pids)


def _divided_memory(pid: int) -> int:
    try:
        with open(f"{PROC}/{pid}/smaps_rollup", encoding="ascii") as file:
            kilobytes = next(line.split()[1] for line in file if line.startswith("Pss_Anon:"))
    except (OSError, StopIteration):  # gone, hidden, or an older Linux
        return own_memory([pid])
    return int(kilobytes) << 10


def _own_memory(pid: int) -> int:
    if sys.platform == "win32":
        return 0
    try:
        with open(f"{PROC}/{pid}/statm", encoding="ascii") as file:
            _, resident, shared, *_ = map(int, file.read().split())
    except (OSError, ValueError):
        return 0
    return (resident - shared) * os.sysconf("SC_PAGE_SIZE")
