"""Marks that a teacher has given back: texts in ~/marks.

One that came while the desktop did not run is announced at the next start, until it was opened.
"""

from __future__ import annotations

import contextlib
import json
import threading
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.classroom.order import Order
from day6_core.session.harmless import one_line
from day6_core.whole_file import write_private

if TYPE_CHECKING:
    from day6_tui.app import Day6App

FOLDER = "marks"
READ = Path(".config", "day6-tui", "marks_read.json")
MOST = 3
"""Are announced at a start, the newest."""
MOST_KNOWN = 500


class Marks:
    """Finds what was not opened; `announce` tells of a file like an order of the teacher's."""

    def __init__(self, app: Day6App, announce: Callable[[Order], None]) -> None:
        self._app = app
        self._announce = announce
        self._has_looked = False

    def look(self) -> None:
        """Look once, as soon as there is a home, without keeping anybody waiting."""
        desk = self._app.machine.desk
        if not self._has_looked and desk is not None:
            self._has_looked = True
            threading.Thread(target=self._find, args=(desk.home,), name="day6-marks", daemon=True).start()

    def _find(self, home: Path) -> None:
        with contextlib.suppress(OSError, RuntimeError):  # no marks; the desktop has ended
            read = _read(home)
            found = [path for path in (home / FOLDER).glob("*.md") if path.name not in read and path.is_file()]
            newest = sorted(found, key=lambda path: path.stat().st_mtime)[-MOST:]
            for path in newest:
                if one_line(path.name) == path.name:
                    self._app.call_from_thread(self._announce, Order("file", text=f"{FOLDER}/{path.name}"))

    def opened(self, name: str) -> None:
        """The pupil has opened a file that was handed over."""
        folder, _, file = name.rpartition("/")
        desk = self._app.machine.desk
        if folder == FOLDER and desk is not None:
            with contextlib.suppress(OSError):  # it is announced once more
                known = json.dumps(sorted({*_read(desk.home), file})[-MOST_KNOWN:]).encode()
                write_private(desk.home / READ, known)


def _read(home: Path) -> set[str]:
    """The names of files that were opened."""
    try:
        found = json.loads((home / READ).read_bytes())
    except (OSError, ValueError):
        return set()
    return set(map(str, found)) if isinstance(found, list) else set()
