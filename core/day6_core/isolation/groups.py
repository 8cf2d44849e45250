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
from pathlib import Path

from day6_core.isolation.cell import Limits
from day6_core.system.control_groups import Tree, memory_used, read

PARENT = "day6-cells"
_LEAF = "day6-server"
_V1 = ("memory", "pids", "cpu")
_SECONDS = 5.0


def group_of(tree: Tree, name: str) -> Path:
    """Return the folder of a cell's group."""
    return tree.own / PARENT / name


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
                group_of(tree, probe).rmdir()
        good.append(tree)
    return good


def make(tree: Tree, name: str, limits: Limits) -> Path:
    """Make the group of a cell and set its limits; return its file `cgroup.procs`. Raises OSError."""
    group = group_of(tree, name)
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
    return [int(word) for word in read(group_of(tree, name) / "cgroup.procs").split()]


def memory_of(found: list[Tree], name: str) -> int | None:
    """Return the bytes a cell's group takes (without files that are only cached), None where nobody counts."""
    for tree in found:
        if "memory" in tree.controllers:
            return memory_used(group_of(tree, name), is_v2=tree.is_v2)
    return None


def end(found: list[Tree], name: str) -> bool:
    """Kill what is in a cell's groups and remove them; return whether they are gone."""
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    until = time.monotonic() + _SECONDS
    while True:
        for tree in found:
            with contextlib.suppress(OSError):  # before Linux 5.14, or version 1
                (group_of(tree, name) / "cgroup.kill").write_text("1", encoding="ascii")
            for pid in members(tree, name):
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
            with contextlib.suppress(OSError):  # somebody is still in it
                group_of(tree, name).rmdir()
        if not any(group_of(tree, name).exists() for tree in found):
            return True
        if time.monotonic() >= until:
            return False
        time.sleep(0.01)
