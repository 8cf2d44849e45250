"""Namespaces by bubblewrap (`bwrap`), for a server that is not root: each pupil has files and process numbers of his own."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.isolation import enter, groups, installed, left
from day6_core.isolation.cell import Cell
from day6_core.isolation.mode import Mode, key

assert not TYPE_CHECKING or sys.platform == "linux"

_NAMESPACES = ("--unshare-user", "--unshare-pid", "--unshare-ipc", "--unshare-uts", "--unshare-cgroup-try")


class Bubblewrap(Mode):
    """A pupil sees programs, his home and his runtime folder; no other process, file or socket exists for him.

    Without `Cell.network` he also has a loopback interface of his own. With it, the ports of 127.0.0.1 are everybody's;
    abstract sockets stay apart where Landlock can do that.
    """

    name = "bubblewrap"
    forks = False
    _counts = frozenset({"processes"})  # RLIMIT_NPROC counts those of a user namespace

    def rlimits(self, cell: Cell) -> dict[str, int]:
        """Return the limits of each process, and of the number in the namespace."""
        return {**super().rlimits(cell), "NPROC": cell.limits.processes}

    def temporary(self, cell: Cell) -> Path:
        """Return /tmp, which is the pupil's alone."""
        return Path("/tmp")

    def plan(self, cell: Cell, descriptors: Iterable[int] = ()) -> enter.SandboxPlan:
        """Return what is done inside, where the namespace counts from nothing."""
        return enter.SandboxPlan(
            folder=str(cell.home),
            environment=self.environment(cell),
            limits=self.rlimits(cell),
            scoped=True,
            descriptors=list(descriptors),
        )

    def command(self, cell: Cell, argv: list[str], descriptors: Iterable[int] = ()) -> list[str]:
        """Return the command line of bwrap."""
        words = ["bwrap", *_NAMESPACES, "--die-with-parent", *_mounts(cell)]
        words += ["--hostname", "day6"]
        words += [] if cell.network else ["--unshare-net"]
        words += ["--", *enter.command(cell, self.plan(cell, descriptors), argv)]
        if not self.trees:
            return words
        outside = enter.SandboxPlan(
            folder="/",
            environment={},
            groups=self.group_files(cell),
            descriptors=list(descriptors),
        )
        return enter.command(cell, outside, words)

    def end(self, cell: Cell) -> bool:
        """Kill bwrap, and with it everything in its namespace; return whether nothing is left."""
        gone = left.end_marked(cell.mark, gently=False)
        return groups.end(self.trees, key(cell)) and gone


def _mounts(cell: Cell) -> list[str]:
    """Return the file system as words for bwrap, what is higher up first: what lies deeper covers it."""
    private = {cell.home.parent, cell.runtime.parent, *map(Path, ("/tmp", "/run", "/var/tmp", "/dev/shm"))}
    limit = ["--size", str(cell.limits.disk)] if takes_size() else []
    table: dict[Path, list[str]] = {path: [*limit, "--tmpfs", str(path)] for path in private if path != Path("/")}
    table |= {Path(folder): ["--ro-bind", folder, folder] for folder in installed.folders()}
    if cell.network:
        for folder in ("/run/systemd/resolve", "/run/resolvconf", "/run/NetworkManager"):  # where resolv.conf points to
            table[Path(folder)] = ["--ro-bind-try", folder, folder]
    for path in cell.hidden:
        if path.exists():
            table[path] = ["--tmpfs", str(path)] if path.is_dir() else ["--ro-bind", "/dev/null", str(path)]
    table[Path("/proc")] = ["--proc", "/proc"]
    table[Path("/dev")] = ["--dev", "/dev"]
    table |= {path: ["--bind", str(path), str(path)] for path in (cell.home, cell.runtime)}
    return [word for path in sorted(table, key=lambda path: len(path.parts)) for word in table[path]]


@cache
def takes_size() -> bool:
    """Return whether this bwrap can limit what it keeps in memory."""
    said = subprocess.run(["bwrap", "--help"], stdin=subprocess.DEVNULL, capture_output=True, timeout=30)
    return b"--size " in said.stdout + said.stderr


def is_installed() -> bool:
    """Return whether there is a `bwrap` on the path."""
    return shutil.which("bwrap") is not None and hasattr(os, "geteuid")
