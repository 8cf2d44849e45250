"""Reads a lesson again while its author is writing it."""

from __future__ import annotations

import logging
import time
from pathlib import Path

from day6_core.lessons.document import Lesson
from day6_core.lessons.reading import read_lesson
from day6_core.session.threads import in_thread

_log = logging.getLogger(__name__)

READ_SECONDS = 1.0
"""Between two looks whether the file was changed."""


class FollowedFile:
    """The file of a lesson that is open."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._read_at = time.monotonic()
        self._stamp = _stamp(path)

    async def changed(self) -> Lesson | None:
        """The lesson anew if its file was changed since the last call. Raises LessonMistakes."""
        now = time.monotonic()
        if now - self._read_at < READ_SECONDS:
            return None
        self._read_at = now
        stamp = _stamp(self.path)
        if stamp is None or stamp == self._stamp:
            return None
        self._stamp = stamp
        try:
            return await in_thread(lambda: read_lesson(self.path))
        except OSError as error:
            _log.info("the lesson's file cannot be read: %s", error)
            return None


def _stamp(path: Path) -> tuple[int, int] | None:
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size
