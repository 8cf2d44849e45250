"""What all linters are told, and which files they look at."""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterator


def parser_for(linter: str, what: str) -> argparse.ArgumentParser:
    """Return a parser of what every linter takes; words that it doesn't know end it, as in ROS."""
    parser = argparse.ArgumentParser(prog=linter, description=what)
    parser.add_argument("paths", nargs="*", default=[os.curdir], help="files and folders")
    parser.add_argument("--exclude", metavar="filename", nargs="*", default=[], help="files to leave out")
    return parser


def files_below(paths: list[str], suffix: str | tuple[str, ...]) -> Iterator[str]:
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
