"""Control groups (cgroups): one for each cell, below the server's own, with limits that count all its processes together.

Version 1 has a tree for each controller, version 2 one for all; a machine may have both, and in a container or for a user without
rights none of them may be writable. `usable` tells which controllers are, by trying.
"""

from __future__ import annotations

import contextlib
import errno
import os
import signal
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from day6_core.isolation.cell import Limits

PARENT = "day6-cells"
_LEAF = "day6-server"
_V1 = ("memory", "pids", "cpu")
_SECONDS = 5.0


@dataclass(frozen=True)
class Tree:
    """The server's own group in one mounted hierarchy, and the controllers that limit something in it."""

    own: Path
    is_v2: bool
    controllers: frozenset[str]
    """Empty for a hierarchy that only groups processes; in version 2 that still ends them all at once."""

    def group(self, name: str) -> Path:
        """Return the folder of a cell's group."""
        return self.own / PARENT / name


def trees(mounts: str | None = None, memberships: str | None = None) -> list[Tree]:
    """Find the hierarchies this process is in; the arguments stand for /proc/self/mounts and /proc/self/cgroup."""
    if mounts is None or memberships is None:
        try:
            mounts = Path("/proc/self/mounts").read_text(encoding="utf-8", errors="replace")
            memberships = Path("/proc/self/cgroup").read_text(encoding="utf-8", errors="replace")
        except OSError:
            return []
    places = {}
    for line in memberships.splitlines():
        number, names, path = line.split(":", 2)
        places["" if number == "0" else names] = path.lstrip("/")
    found = []
    for line in mounts.splitlines():
        _, place, kind, options, *_ = line.split(" ")
        if kind == "cgroup2" and "" in places:
            own = Path(place, places[""])
            found.append(Tree(own, True, frozenset(read(own / "cgroup.controllers").split()) & {*_V1}))
        elif kind == "cgroup":
            for names, path in places.items():
                here = frozenset(names.split(",")) & {*_V1}
                if here and here <= set(options.split(",")):
                    found.append(Tree(Path(place, path), False, here))
    return found


def usable(found: list[Tree]) -> list[Tree]:
    """Return the hierarchies in which we can make groups that limit, found out by making one."""
    good = []
    for tree in found:
        probe = f"probe-{os.getpid()}"
        try:
            make(tree, probe, Limits())
        except OSError:
            continue
        finally:
            with contextlib.suppress(OSError):
                tree.group(probe).rmdir()
        good.append(tree)
    return good


def make(tree: Tree, name: str, limits: Limits) -> Path:
    """Make the group of a cell and set its limits; return its file `cgroup.procs`. Raises OSError."""
    group = tree.group(name)
    group.parent.mkdir(exist_ok=True)
    if tree.is_v2:
        _delegate(tree)
    group.mkdir(exist_ok=True)
    for file, value in _settings(tree, limits):
        try:
            (group / file).write_text(value, encoding="ascii")
        except FileNotFoundError:
            if file not in _OPTIONAL:
                raise
    return group / "cgroup.procs"


_OPTIONAL = ("memory.swap.max", "memory.memsw.limit_in_bytes", "memory.oom.group")
"""What a kernel may lack: accounting of swap, ending a whole group at once."""


def _settings(tree: Tree, limits: Limits) -> list[tuple[str, str]]:
    memory, processes = str(limits.memory), str(limits.processes)
    if tree.is_v2:
        table = {
            "memory": [("memory.max", memory), ("memory.swap.max", "0")],
            "pids": [("pids.max", processes)],
            "cpu": [("cpu.weight", str(limits.cpu_weight))],
        }
    else:
        shares = str(max(2, limits.cpu_weight * 1024 // 100))
        table = {
            "memory": [("memory.limit_in_bytes", memory), ("memory.memsw.limit_in_bytes", memory)],
            "pids": [("pids.max", processes)],
            "cpu": [("cpu.shares", shares)],
        }
    return [setting for controller in _V1 if controller in tree.controllers for setting in table[controller]]


def _delegate(tree: Tree) -> None:
    """Version 2: hand the controllers down. A group with groups below may hold no processes: the server goes into a leaf."""
    if not tree.controllers:
        return
    wanted = " ".join(f"+{name}" for name in sorted(tree.controllers))
    for folder in (tree.own, tree.own / PARENT):
        file = folder / "cgroup.subtree_control"
        if tree.controllers <= set(read(file).split()):
            continue
        try:
            file.write_text(wanted, encoding="ascii")
        except OSError as error:
            if error.errno != errno.EBUSY or read(folder / "cgroup.procs").split() != [str(os.getpid())]:
                raise  # others are in it, and they are not ours to move
            (folder / _LEAF).mkdir(exist_ok=True)
            (folder / _LEAF / "cgroup.procs").write_text(str(os.getpid()), encoding="ascii")
            file.write_text(wanted, encoding="ascii")


def members(tree: Tree, name: str) -> list[int]:
    """Return the processes of a cell's group."""
    return [int(word) for word in read(tree.group(name) / "cgroup.procs").split()]


def memory_used(found: list[Tree], name: str) -> int | None:
    """Return the bytes a cell's group takes (without files that are only cached), None where nobody counts."""
    for tree in found:
        if "memory" in tree.controllers:
            group = tree.group(name)
            total = read(group / ("memory.current" if tree.is_v2 else "memory.usage_in_bytes")).strip()
            return max(0, int(total) - idle_files(group, is_v2=tree.is_v2)) if total.isdigit() else None
    return None


def idle_files(group: Path, *, is_v2: bool) -> int:
    """Return the bytes of a group that hold files which are only cached."""
    unused = "inactive_file" if is_v2 else "total_inactive_file"
    lines = (line.split() for line in read(group / "memory.stat").splitlines())
    return sum(int(value) for key, value in lines if key == unused)


def end(found: list[Tree], name: str) -> bool:
    """Kill what is in a cell's groups and remove them; return whether they are gone."""
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    until = time.monotonic() + _SECONDS
    while True:
        for tree in found:
            with contextlib.suppress(OSError):  # before Linux 5.14, or version 1
                (tree.group(name) / "cgroup.kill").write_text("1", encoding="ascii")
            for pid in members(tree, name):
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
            with contextlib.suppress(OSError):  # somebody is still in it
                tree.group(name).rmdir()
        if not any(tree.group(name).exists() for tree in found):
            return True
        if time.monotonic() >= until:
            return False
        time.sleep(0.01)


def read(file: Path) -> str:
    """Return what such a file says, "" if there is none."""
    try:
        return file.read_text(encoding="ascii", errors="replace")
    except OSError:
        return ""
