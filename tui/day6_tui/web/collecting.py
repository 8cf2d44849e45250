"""Collects a pupil's work from the home folder, whether the pupil is there or not, and sees whether it has changed since."""

from __future__ import annotations

import asyncio
import contextlib
import os
import time
from collections.abc import Iterable

from day6_core.lessons import work
from day6_core.lessons.progress import FOLDER, LARGEST, Progress, ProgressError, decode
from day6_core.lessons.work import Task, Work
from day6_core.workspace.export import LEFT_OUT
from day6_tui.web.assignments import Assignment, AssignmentStore, Collected
from day6_tui.web.places import Places
from day6_tui.web.pupil_files import Bounds, PupilFiles, Wanted

BOUNDS = Bounds(leaves_out=LEFT_OUT)
PROGRESS = Bounds(files=10, file_bytes=LARGEST, bytes=10 * LARGEST)
"""Progress files in one home: a pupil can have several names."""


class Collector:
    """Reads homes and fills the store."""

    def __init__(self, files: PupilFiles, places: Places, store: AssignmentStore) -> None:
        self._files = files
        self._places = places
        self._store = store

    async def find(self, name: str, task: Task) -> Work:
        """Read what there is of a task in a pupil's home. Raises IsolationError, OSError."""
        if not os.path.lexists(self._places.home(name)):
            return Work()
        wanted = [Wanted(*each) for each in work.wanted_of(task)]
        tree = await self._files.tree(name, wanted, BOUNDS)
        return Work(tree.files, tree.left_out, await self._progress(name))

    async def _progress(self, name: str) -> Progress:
        wanted = [Wanted(FOLDER.as_posix(), deep=False, endings=(".json",))]
        tree = await self._files.tree(name, wanted, PROGRESS)
        return await asyncio.to_thread(_joined, name, list(tree.files.values()))

    def collect(
        self, assignment: Assignment, name: str, found: Work, before: Collected | None, *, late: bool
    ) -> Collected | None:
        """Keep what was found; None if there is nothing. What is the same as before is not kept again.

        It blocks. Raises OSError, TooLarge.
        """
        if not found.files and not work.has_begun(assignment.task, found):
            return before
        mark, now = work.fingerprint(assignment.task, found), time.time()
        if before is not None and before.print == mark:
            return before
        home = str(self._places.home(name))
        packed = work.pack(assignment.task, found, name, home, when=round(now, 3), late=late)
        return self._store.collect(assignment.id, name, packed, now)


def _joined(name: str, files: Iterable[bytes]) -> Progress:
    """What the progress files of a home say; one that is none says nothing."""
    found = Progress(name)
    for data in files:
        with contextlib.suppress(ProgressError):
            found = found.joined(decode(data))
    return found
