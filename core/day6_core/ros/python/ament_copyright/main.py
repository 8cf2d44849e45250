"""Checks every source file for a copyright notice at its beginning."""

from __future__ import annotations

import os
import sys

from ament_lint.files import files_below

_SEARCHED_LINES = 40
"""The number of lines at the beginning that are searched for a notice."""


def main(argv: list[str] | None = None) -> int:
    """Check the given files and folders (by default the current one); returns 1 if one has no notice."""
    files = sorted(files_below(sys.argv[1:] if argv is None else argv, ".py"))
    missing = [path for path in files if not _is_setup(path) and not _has_notice(path)]
    for path in missing:
        print(f"{path}: could not find copyright notice", file=sys.stderr)
    if not missing:
        print("No problems found")
    return 1 if missing else 0


def _is_setup(path: str) -> bool:
    """Say whether this is a package's own setup.py, which needs no notice (ament_copyright/crawler.py)."""
    folder, name = os.path.split(path)
    return name == "setup.py" and os.path.exists(os.path.join(folder, "package.xml"))


def _has_notice(path: str) -> bool:
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = file.read().splitlines()
    return not lines or any("copyright" in line.lower() for line in lines[:_SEARCHED_LINES])
