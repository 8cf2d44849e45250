"""Files and folders as far as they are looked at: bounded, and without an error for what cannot be read."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

MOST_FILES = 300
"""Files below one folder."""

LONGEST_FILE = 2_000_000
"""Characters."""


def text_of(path: Path) -> str:
    """Return the text of a file, '' if it cannot be read."""
    with suppress(OSError), path.open(encoding="utf-8", errors="replace") as file:
        return file.read(LONGEST_FILE)
    return ""


def names_in(folder: Path) -> list[str]:
    """Return what is in a folder (sorted), nothing if it cannot be read."""
    with suppress(OSError):
        return sorted(os.listdir(folder))
    return []


def files_in(folder: Path, suffix: str = "", most: int = MOST_FILES, *, hidden: bool = False) -> Iterator[Path]:
    """Yield the files below a folder that somebody wrote: no copies of editors, none that are compiled or hidden."""
    count = 0
    for here, folders, names in os.walk(folder):
        folders[:] = sorted(each for each in folders if each != "__pycache__" and not each.startswith("."))
        for each in sorted(names):
            is_written = not each.endswith((".pyc", "~", ".swp")) and (hidden or not each.startswith("."))
            if is_written and each.endswith(suffix):
                count += 1
                if count > most:
                    return
                yield Path(here, each)
