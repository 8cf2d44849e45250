"""Which files the linters look at."""

from __future__ import annotations

import os
from collections.abc import Iterator


def files_below(paths: list[str], suffix: str) -> Iterator[str]:
    """Yield the named files, and those with a suffix below the named folders (by default the current one), sorted in each.

    Folders that begin with `.` or `_` and those with an AMENT_IGNORE are left out.
    """
    for path in paths or ["."]:
        if os.path.isfile(path):
            yield path
        for folder, folders, files in os.walk(path):
            if "AMENT_IGNORE" in files or "AMENT_IGNORE" in folders:
                folders[:] = []
                continue
            folders[:] = sorted(name for name in folders if not name.startswith((".", "_")))
            yield from (os.path.join(folder, name) for name in sorted(files) if name.endswith(suffix))
