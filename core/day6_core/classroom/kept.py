"""A value that outlives a killed program: it is in its file before what it says is done. Only this user can read it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

from day6_core.whole_file import PRIVATE, make_private_folder, replace_file

LESSON_SECONDS = 24 * 3600.0
"""After which what belongs to a lesson is kept no longer."""


class Kept(Protocol):
    """Where a value is kept, as JSON."""

    def restore(self, take: Callable[[Any], object]) -> None:
        """Give `take` what was written last, if anything was.

        It raises ValueError, TypeError, KeyError or AttributeError if that makes no sense.
        """

    def write(self, value: Any) -> None:
        """Keep this in place of it. Only a power cut may lose it: nothing waits for the disk."""


class Unkept:
    """Keeps nothing."""

    def restore(self, take: Callable[[Any], object]) -> None:
        pass

    def write(self, value: Any) -> None:
        pass


class KeptFile:
    """Keeps it in a file. `failed` is told once of what cannot be written, `damaged` of a file that is not ours."""

    def __init__(self, file: Path, failed: Callable[[OSError], None], damaged: Callable[[Path], None]) -> None:
        self._file = file
        self._failed = failed
        self._damaged = damaged
        self._has_failed = False

    def restore(self, take: Callable[[Any], object]) -> None:
        try:
            if (found := json.loads(self._file.read_bytes())) is not None:
                take(found)
        except FileNotFoundError:
            pass
        except (OSError, ValueError, RecursionError, TypeError, KeyError, AttributeError):
            self._damaged(self._file)

    def write(self, value: Any) -> None:
        try:
            make_private_folder(self._file.parent)
            replace_file(self._file, json.dumps(value, ensure_ascii=True).encode(), mode=PRIVATE, sync=False)
        except OSError as error:
            if not self._has_failed:
                self._has_failed = True
                self._failed(error)
