"""What begins anew for a pupil whose desktop has ended: the desk, a lesson, the home. Nothing is lost, whenever it breaks off.

What was is kept first, under a name with the time, and only then something else is in its place, in one step. The files are the
pupil's: no link is followed, and nothing that belongs to another is touched. Each returns where what was is kept, "" if there was
nothing.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import time
from collections.abc import Callable, Iterator

from day6_core.classroom.homes import BEFORE, opened_folder, read_file
from day6_core.isolation.cell import Cell
from day6_core.isolation.mode import Mode
from day6_core.lessons import progress
from day6_core.lessons.progress import FOLDER, LARGEST
from day6_core.places import SESSION_FILE
from day6_tui.web.pupil_files import owner_of, write_file

MOST_FILES = 100
"""Progress files of one home: one for each name under which somebody learns there."""


def now() -> str:
    """What stands behind the names of what is kept."""
    return time.strftime("%Y%m%d-%H%M%S")


def clear_desk(cell: Cell) -> str:
    """Have the desktop come back without windows and programs. Raises OSError."""
    with contextlib.suppress(FileNotFoundError), opened_folder(cell.home, ".config", "day6-tui") as folder:
        kept = _free(lambda name: _is_in(folder, name), f"{SESSION_FILE}.{now()}")
        os.rename(SESSION_FILE, kept, src_dir_fd=folder, dst_dir_fd=folder)
        return f".config/day6-tui/{kept}"
    return ""


def reset_lesson(cell: Cell, lesson: str) -> str:
    """Have a lesson begin anew, whatever name the pupil has there. Raises OSError, ProgressError, Strange."""
    kept = ""
    with contextlib.suppress(FileNotFoundError), opened_folder(cell.home, *FOLDER.parts) as folder:
        names = sorted(name for name in os.listdir(folder) if name.endswith(".json"))
        for name in names[:MOST_FILES]:
            data = read_file(folder, name, LARGEST, owner=owner_of(cell))
            found = progress.decode(data)
            if lesson not in found.steps and lesson not in found.at:
                continue
            found.forget(lesson)
            copy = _free(lambda each: _is_in(folder, each), f"{name}.{now()}")
            for each, text in ((copy, data), (name, progress.encode(found))):
                write_file(cell, folder, each, text, mode=0o600, replaces=True)
            kept = f"{FOLDER.as_posix()}/{copy}"
    return kept


def reset_home(mode: Mode, cell: Cell) -> str:
    """Put the whole home aside and an empty one in its place. Raises OSError, IsolationError.

    Between both steps there is no home, as before the pupil's first coming: the next desktop makes one.
    """
    aside = cell.home.parent.with_name(BEFORE)
    aside.mkdir(mode=0o700, exist_ok=True)  # no pupil gets in, not even into what was theirs
    kept = _free(lambda name: os.path.lexists(aside / name), f"{cell.home.name}-{now()}")
    try:
        os.rename(cell.home, aside / kept)
    except FileNotFoundError:
        kept = ""
    mode.prepare(cell)
    return kept and f"{BEFORE}/{kept}"


def _is_in(folder: int, name: str) -> bool:
    try:
        os.stat(name, dir_fd=folder, follow_symlinks=False)
    except FileNotFoundError:
        return False
    return True


def _free(is_taken: Callable[[str], bool], name: str) -> str:
    """The name, or one beside it that nothing has."""
    names: Iterator[str] = itertools.chain([name], (f"{name}-{number}" for number in itertools.count(2)))
    return next(each for each in names if not is_taken(each))
