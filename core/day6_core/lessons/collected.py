"""What the pupils of a class have in their homes, as submissions: as if each of them had typed `day6-tui submit`.

A home is other people's files and may change at any moment, so what is handed in is first copied out of it: no link is followed,
no pipe is waited for, and nothing large is taken (`day6_core/classroom/homes.py`).
"""

from __future__ import annotations

import os
import stat
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from day6_core.classroom.homes import PupilHome, Strange, opened_folder, read_file
from day6_core.lessons.class_table import so_far
from day6_core.lessons.grading.archive import DEEPEST, LARGEST_FILE, MOST_BYTES, MOST_FILES
from day6_core.lessons.submission import LOOSE, Packed, SubmissionError, submit
from day6_core.lessons.texts import Say
from day6_core.reason import reason
from day6_core.whole_file import replace_file
from day6_core.workspace.export import is_tools_folder

WORKSPACE = ("ros2_ws", "src")
MOST_ENTRIES = 10_000
"""Names that are looked at in a home."""


def collect(home: PupilHome, target: Path, lesson: str = "") -> Packed:
    """Pack what a pupil has. Raises SubmissionError, ExportError, OSError; then no new file is left."""
    with tempfile.TemporaryDirectory(prefix="d6s-") as folder:
        copy = Path(folder) / "home"
        copy.mkdir()
        left_out = _Copying(home.folder, copy).everything()
        packed = submit(copy, target, home.name, lesson, progress=so_far(home).progress, known_as=home.folder)
    packed.left_out[:0] = left_out
    return packed


class _Copying:
    """Copies one home, as far as it can be handed in."""

    def __init__(self, home: Path, copy: Path) -> None:
        self._home = home
        self._copy = copy
        self._files = self._bytes = self._names = 0
        self._left_out: list[Say] = []

    def everything(self) -> list[Say]:
        """Copy loose programs and the workspace; return what was left out. Raises SubmissionError, OSError."""
        if sys.platform == "win32":
            raise NotImplementedError
        with opened_folder(self._home) as number:
            for name in self._entries(number):
                if name.endswith(LOOSE) and not name.startswith("."):
                    self._take(number, Path(name))
        try:
            with opened_folder(self._home, *WORKSPACE) as number:
                for root, folders, names, inner in os.fwalk(".", dir_fd=number):
                    below = Path(*WORKSPACE, root)
                    self._prune(below, folders, inner)
                    for name in names:
                        self._take(inner, below / name)
        except FileNotFoundError:
            pass  # no workspace yet
        except OSError as error:
            self._leave(Path(*WORKSPACE), reason(error))
        return self._left_out

    def _entries(self, folder: int) -> Iterator[str]:
        with os.scandir(folder) as entries:
            for entry in entries:
                self._names += 1
                if self._names > MOST_ENTRIES:
                    self._leave(Path(), Say("report.unread.many"))
                    return
                yield entry.name

    def _prune(self, below: Path, folders: list[str], number: int) -> None:
        """Go into no folder of tools, no link and nothing endless."""
        wanted = []
        for name in folders:
            if is_tools_folder(name):
                continue
            try:
                kind = os.stat(name, dir_fd=number, follow_symlinks=False).st_mode
            except OSError as error:  # it has gone
                self._leave(below / name, reason(error))
                continue
            if not stat.S_ISDIR(kind):
                self._leave(below / name, Say("report.unread.strange"))
            elif len((below / name).parts) > DEEPEST:
                self._leave(below / name, Say("report.unread.many"))
            else:
                wanted.append(name)
        folders[:] = wanted

    def _take(self, folder: int, inside: Path) -> None:
        try:
            data = read_file(folder, inside.name, LARGEST_FILE)
            runs = os.stat(inside.name, dir_fd=folder, follow_symlinks=False).st_mode & stat.S_IXUSR
        except Strange as error:
            self._leave(inside, Say(f"report.unread.{error}"))
            return
        except OSError as error:  # it has gone, or is closed
            self._leave(inside, reason(error))
            return
        self._files += 1
        self._bytes += len(data)
        if self._files > MOST_FILES or self._bytes > MOST_BYTES:
            raise SubmissionError("submit.large", size=self._bytes // 1_000_000, most=MOST_BYTES // 1_000_000)
        target = self._copy / inside
        target.parent.mkdir(parents=True, exist_ok=True)
        replace_file(target, data, mode=0o777 if runs else 0o666, sync=False)

    def _leave(self, inside: Path, why: object) -> None:
        self._left_out.append(Say("report.broken", file=self._home / inside, reason=why))
