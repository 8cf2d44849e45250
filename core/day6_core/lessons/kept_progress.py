"""Keeps a pupil's progress while lessons are open: reads its file, and writes it after every change."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from pathlib import Path

from day6_core.lessons.progress import Progress, ProgressError, file_of, load, save
from day6_core.reason import reason
from day6_core.session.threads import Newest, in_thread

_log = logging.getLogger(__name__)

RETRY_SECONDS = 2.0
"""Seconds between tries where the file cannot be written."""


class KeptProgress:
    """One pupil's progress and its file, which is written in a thread."""

    def __init__(self, home: Path, pupil: str) -> None:
        self.progress = Progress(pupil)
        self.unsaved = False
        """Whether the progress was changed since it was last written."""
        self.failed = ""
        """Why the progress could not be kept."""
        self._again = 0.0
        """When to try again after that, on `time.monotonic`."""
        self._file = file_of(home, pupil)
        self._saving = False
        self._newest = Newest()

    @property
    def is_due(self) -> bool:
        """Whether it is time to write: one writing after the other."""
        return self.unsaved and not self._saving and time.monotonic() >= self._again

    @property
    def unwritten(self) -> bool:
        """Whether the file may lack something that is known."""
        return self.unsaved or self._saving

    async def load(self) -> None:
        """Read how far the pupil is; the beginning where the file cannot be used."""
        try:
            progress = await in_thread(lambda: load(self._file))
        except (ProgressError, OSError) as error:
            self.failed = reason(error)
        else:
            progress.pupil = self.progress.pupil
            self.progress = progress

    async def save(self) -> None:
        """Write what is known now."""
        self.unsaved, self._saving = False, True
        progress = self.progress.copy()
        try:
            await in_thread(self._newest.of(lambda: save(self._file, progress)))
            self.failed = ""
        except (ProgressError, OSError) as error:
            self.failed, self.unsaved, self._again = reason(error), True, time.monotonic() + RETRY_SECONDS
        finally:
            self._saving = False

    def last_writing(self) -> Callable[[], None]:
        """Return, for a thread, what writes all that is known when nothing changes any more."""
        return self._newest.of(self._write_last)

    def _write_last(self) -> None:
        try:
            save(self._file, self.progress)
        except (ProgressError, OSError) as error:
            _log.warning("the progress was not kept: %s", reason(error))
