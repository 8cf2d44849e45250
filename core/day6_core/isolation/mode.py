"""What every way of keeping pupils apart has in common."""

from __future__ import annotations

import errno
import os
import sys
import zlib
from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from pathlib import Path

from day6_core.isolation import enter, groups, left
from day6_core.isolation.cell import Cell, Used
from day6_core.system.control_groups import Tree
from day6_core.system.processes import family, own_memory, processes

MOST_FILES = 200_000
"""Files that are looked at when the space of a home is summed up; with more, the sum is too small."""


class Mode(ABC):
    """One way of keeping pupils apart. `open` is what a trial on this machine got through; None: not tried."""

    name: str

    def __init__(self, trees: Iterable[Tree] = ()) -> None:
        self.trees = list(trees)
        self.open: frozenset[str] | None = None

    @property
    def separates(self) -> bool:
        """Whether no pupil gets at another's files, processes or sockets, as far as the trial on this machine can tell."""
        return self.open is not None and all(name.startswith("visible.") for name in self.open)

    @property
    def enforces(self) -> frozenset[str]:
        """What is limited for a pupil as a whole: "memory", "processes", "cpu". The rest holds for each process or not at all."""
        counted = {controller for tree in self.trees for controller in tree.controllers}
        return frozenset({"pids": "processes"}.get(name, name) for name in counted) | self._counts

    _counts: frozenset[str] = frozenset()

    forks = True
    """Whether any process can go into a cell; False: only what a program starts there is in it."""

    def uid_of(self, name: str, homes: Path) -> int | None:
        """Return the Unix user of the pupil whose home is `homes`/`name`; None where all are the server's."""
        return None

    def closed_before(self, folders: Iterable[Path]) -> Path | None:
        """Return the first folder that keeps pupils from one of these; None if they get to all."""
        return None

    def prepare(self, cell: Cell) -> None:
        """Make the folders and control groups. Raises IsolationError, OSError."""
        for folder in (cell.home, cell.runtime, self.temporary(cell)):
            folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        self._make_groups(cell)

    def _make_groups(self, cell: Cell) -> list[str]:
        return [str(groups.make(tree, key(cell), cell.limits)) for tree in self.trees]

    def command(self, cell: Cell, argv: list[str], descriptors: Iterable[int] = ()) -> list[str]:
        """Return the command line that starts `argv` in the cell; `descriptors` stay open, besides 0, 1 and 2.

        It stays in the session and on the terminal it is started on. Raises IsolationError.
        """
        return enter.command(cell, self.plan(cell, descriptors), argv)

    @abstractmethod
    def plan(self, cell: Cell, descriptors: Iterable[int] = ()) -> enter.SandboxPlan:
        """Return what a process does to go into the cell, the whole way where it `forks`. Raises IsolationError."""

    def environment(self, cell: Cell) -> dict[str, str]:
        """Return the variables that name the cell's folders; of others, few get in (`enter.KEPT_VARIABLES`)."""
        return {
            "HOME": str(cell.home),
            "USER": cell.name,
            "LOGNAME": cell.name,
            "SHELL": "/bin/sh",
            "DAY6_RUNTIME_DIR": str(cell.runtime),
            "XDG_DATA_HOME": str(cell.home / ".local" / "share"),
            "TMPDIR": str(self.temporary(cell)),
        }

    def temporary(self, cell: Cell) -> Path:
        """Return the folder for the cell's temporary files."""
        return cell.runtime / "tmp"

    def rlimits(self, cell: Cell) -> dict[str, int]:
        """Return the limits of each process, for what no control group counts."""
        limits = {"FSIZE": cell.limits.disk, "NOFILE": cell.limits.open_files}
        if "memory" not in self.enforces:
            limits["DATA"] = cell.limits.memory
        return limits

    def processes(self, cell: Cell) -> list[int]:
        """Return the ids of the cell's processes."""
        return self.processes_of([cell])[0]

    def processes_of(self, cells: Sequence[Cell]) -> list[list[int]]:
        """Return the ids of the processes of each of these cells, found in one look at all."""
        holders = left.all_marked([cell.mark for cell in cells])
        table = processes()
        return [sorted({*holders[cell.mark], *family(table, holders[cell.mark])}) for cell in cells]

    def group_files(self, cell: Cell) -> list[str]:
        """Return the files into which the ids of the cell's processes are written, one in each hierarchy."""
        return [str(groups.group_of(tree, key(cell)) / "cgroup.procs") for tree in self.trees]

    def used(self, cell: Cell) -> Used:
        """Measure what the cell takes. It walks the home folder: not for an event loop's thread."""
        pids = self.processes(cell)
        memory = groups.memory_of(self.trees, key(cell))
        return Used(own_memory(pids) if memory is None else memory, len(pids), self.disk_used(cell))

    def disk_used(self, cell: Cell) -> int:
        """Return the bytes in the cell's folders, by walking them; of `used` this costs least, as no process is looked for."""
        return disk_of(cell.home) + disk_of(cell.runtime)

    @abstractmethod
    def end(self, cell: Cell) -> bool:
        """Kill whatever is left of the cell; return whether nothing is. It may take seconds: not for an event loop's thread."""


def key(cell: Cell) -> str:
    """Return a word for the cell that is a file name, whatever the pupil's name is, and no other cell's."""
    plain = "".join(letter for letter in cell.name if letter.isascii() and letter.isalnum())[:32]
    return f"{plain}-{zlib.crc32(os.fsencode(cell.runtime)):08x}"


def disk_of(home: Path) -> int:
    """Return the bytes in a home folder."""
    if sys.platform == "win32":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    total, count = 0, 0
    waiting = [str(home)]
    while waiting and count < MOST_FILES:
        try:
            with os.scandir(waiting.pop()) as entries:
                for entry in entries:
                    count += 1
                    total += entry.stat(follow_symlinks=False).st_blocks * 512
                    if entry.is_dir(follow_symlinks=False):
                        waiting.append(entry.path)
        except OSError:
            continue  # removed meanwhile, or closed to us
    return total
