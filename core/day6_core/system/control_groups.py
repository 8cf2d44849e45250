"""Control groups (cgroups) of Linux: which this process is in, and what those above it allow.

Version 1 has a tree for each controller, version 2 one for all, and a machine may have both.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

_CONTROLLERS = frozenset({"memory", "pids", "cpu"})
_UNLIMITED = 1 << 60
"""A limit of memory from here on is none: version 1 says a number of that kind."""


@dataclass(frozen=True)
class Tree:
    """The group of this process in one mounted hierarchy, and the controllers that limit something in it."""

    own: Path
    is_v2: bool
    controllers: frozenset[str]
    """Empty for a hierarchy that only groups processes; in version 2 that still ends them all at once."""
    top: Path = field(default=Path("/"))
    """Where it is mounted: in a container often its own group."""

    @property
    def chain(self) -> tuple[Path, ...]:
        """The group of this process and all above it that can be seen from here."""
        return (self.own, *(each for each in self.own.parents if each.is_relative_to(self.top)))


class MemoryOfGroup(NamedTuple):
    """What a group may have, and what is used there, in bytes."""

    most: int
    used: int


def trees(proc: Path = Path("/proc/self")) -> list[Tree]:
    """Return the hierarchies that this process is in; `proc` is the folder with its files `mountinfo` and `cgroup`."""
    paths = {}
    for line in read(proc / "cgroup").splitlines():
        number, names, path = line.split(":", 2)
        paths["" if number == "0" else names] = path
    found = []
    for line in read(proc / "mountinfo").splitlines():
        before, _, after = line.partition(" - ")
        root, top = (_unescaped(word) for word in before.split(" ")[3:5])
        kind, _, options = after.split(" ")
        if kind == "cgroup2" and "" in paths:
            own = _below(Path(top), root, paths[""])
            here = frozenset(read(own / "cgroup.controllers").split()) & _CONTROLLERS
            found.append(Tree(own, True, here, Path(top)))
        elif kind == "cgroup":
            for names, path in paths.items():
                here = frozenset(names.split(",")) & _CONTROLLERS
                if here and here <= set(options.split(",")):
                    found.append(Tree(_below(Path(top), root, path), False, here, Path(top)))
    return found


def _below(top: Path, root: str, path: str) -> Path:
    """Return where the group `path` is if the group `root` is mounted at `top`: there, if it is none of those below."""
    inner = Path(path)
    own = top / inner.relative_to(root) if inner.is_relative_to(root) else top
    return own if own.is_dir() or not top.is_dir() else top


def _unescaped(word: str) -> str:
    """Return a path of mountinfo, in which a space is \\040."""
    return re.sub(r"\\([0-7]{3})", lambda found: chr(int(found[1], 8)), word)


def memory_limits(found: Iterable[Tree]) -> list[MemoryOfGroup]:
    """Return the limit of each group of memory from ours up."""
    limits = []
    for tree in found:
        for group in tree.chain if tree.is_v2 or "memory" in tree.controllers else ():
            most = _number(read(group / ("memory.max" if tree.is_v2 else "memory.limit_in_bytes")))
            if most is not None and most < _UNLIMITED:
                limits.append(MemoryOfGroup(most, memory_used(group, is_v2=tree.is_v2) or 0))
    return limits


def memory_used(group: Path, *, is_v2: bool) -> int | None:
    """Return the bytes that a group takes, without files that are only cached; None where nobody counts."""
    total = _number(read(group / ("memory.current" if is_v2 else "memory.usage_in_bytes")))
    if total is None:
        return None
    cached = "inactive_file" if is_v2 else "total_inactive_file"
    lines = (line.split() for line in read(group / "memory.stat").splitlines())
    return max(0, total - sum(int(value) for key, value in lines if key == cached))


def core_limits(found: Iterable[Tree]) -> list[float]:
    """Return how many cores each group from ours up may fill, of those that limit it."""
    limits = []
    for tree in found:
        for group in tree.chain if tree.is_v2 or "cpu" in tree.controllers else ():
            if tree.is_v2:
                most, _, period = read(group / "cpu.max").partition(" ")
            else:
                most, period = (read(group / f"cpu.cfs_{name}_us") for name in ("quota", "period"))
            quota, each = _number(most), _number(period)
            if quota is not None and each:
                limits.append(quota / each)
    return limits


def _number(text: str) -> int | None:
    return int(text) if text.strip().isdigit() else None


def read(file: Path) -> str:
    """Return what such a file says, "" if there is none."""
    try:
        return file.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""
