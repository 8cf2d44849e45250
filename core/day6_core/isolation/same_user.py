"""All pupils are the server's own user: with Landlock their files and processes are apart, otherwise nothing is."""

from __future__ import annotations

import sys
from collections.abc import Iterable

from day6_core.isolation import enter, groups, installed, left
from day6_core.isolation.cell import Cell, IsolationError
from day6_core.isolation.mode import Mode, key

_KERNEL = ("/proc", "/sys")
"""What is another's process there stays closed: Landlock asks whether one may trace it."""
_DEVICES = ("/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom", "/dev/tty", "/dev/ptmx", "/dev/pts")


class Nothing(Mode):
    """Separates nothing. A supervisor still ends what a pupil's programs leave behind; limits hold for each process."""

    name = "none"

    def plan(self, cell: Cell, descriptors: Iterable[int] = ()) -> enter.SandboxPlan:
        """Return what the supervisor does."""
        return self._plan(cell, descriptors)

    def _plan(
        self, cell: Cell, descriptors: Iterable[int], readable: Iterable[str] = (), writable: Iterable[str] = ()
    ) -> enter.SandboxPlan:
        return enter.SandboxPlan(
            folder=str(cell.home),
            environment=self.environment(cell),
            groups=self.group_files(cell),
            limits=self.rlimits(cell),
            readable=list(readable),
            writable=list(writable),
            scoped=bool(writable),
            supervise=sys.platform == "linux",
            descriptors=list(descriptors),
        )

    def end(self, cell: Cell) -> bool:
        """Tell the supervisor to end everything, and then end it; return whether nothing is left."""
        gone = left.end_marked(cell.mark, gently=True)
        return groups.end(self.trees, key(cell)) and gone


class Landlock(Nothing):
    """A pupil can open the system's programs, his home and his runtime folder, and signal his own processes only.

    Before version 9 Landlock does not watch who connects to a Unix socket that has a path, and all paths can be listed
    (/proc/net/unix, `ss`): a pupil can then connect to another's sockets, so this does not separate.
    """

    name = "landlock"

    def plan(self, cell: Cell, descriptors: Iterable[int] = ()) -> enter.SandboxPlan:
        """Return what the supervisor does. Raises IsolationError if a rule would open what must stay closed."""
        readable = [*installed.folders(), *_KERNEL]
        for path in (cell.home, cell.runtime, *cell.hidden):
            if any(installed.is_below(path, folder) for folder in readable):
                raise IsolationError("isolation.no.inside", folder=str(path))
        writable = [str(cell.home), str(cell.runtime), *_DEVICES]
        return self._plan(cell, descriptors, readable, writable)
