"""Checks that every source file begins with a copyright notice and a license that ROS knows."""

from __future__ import annotations

import glob
import os
import re
import sys
from itertools import dropwhile, takewhile

from ament_lint.files import files_below, parser_for

_NOTICE = re.compile(
    r"^.?\s*copyright(?:\s+\(c\))?\s+\d{4}(?:-\d{4})?(?:,\s*\d{4}(?:-\d{4})?)*,?\s+\S", re.IGNORECASE | re.MULTILINE
)
_LICENSES = (
    "Licensed under the Apache License, Version 2.0",
    "Permission is hereby granted, free of charge",
    "Redistribution and use in source and binary forms",
    "Use of this source code is governed by a BSD-style license",
    "Use of this source code is governed by an MIT-style license",
    "under the terms of the GNU General Public License",
    "under the terms of the GNU Lesser General Public License",
)
"""What is in the text of each license; ROS compares all of it."""


def main(argv: list[str] | None = None) -> int:
    """Check the given files and folders (by default the current one); returns 1 if one has no notice."""
    parser = parser_for("ament_copyright", "Check files for a copyright notice.")
    chosen = parser.parse_args(sys.argv[1:] if argv is None else argv)
    left_out = {os.path.realpath(path) for pattern in chosen.exclude for path in glob.glob(pattern)}
    files = [path for path in files_below(chosen.paths, ".py") if os.path.realpath(path) not in left_out]
    faults = [(path, fault) for path in sorted(files) if not _is_setup(path) and (fault := _fault_of(path))]
    for path, fault in faults:
        print(f"{path}: {fault}", file=sys.stderr)
    if not faults:
        print("No problems found")
    return 1 if faults else 0


def _is_setup(path: str) -> bool:
    """Say whether this is a package's own setup.py, which needs no notice (ament_copyright/crawler.py)."""
    folder, name = os.path.split(path)
    return name == "setup.py" and os.path.exists(os.path.join(folder, "package.xml"))


def _fault_of(path: str) -> str:
    """Return what the first comment of a file lacks; an empty file needs none."""
    with open(path, encoding="utf-8-sig", errors="replace") as file:
        lines = file.read().splitlines()
    rest = dropwhile(lambda line: line.startswith("#") and re.search(r"^#!|coding[:=]", line), lines)
    block = takewhile(lambda line: line.startswith("#"), dropwhile(lambda line: not line.startswith("#"), rest))
    comment = "\n".join(line[2:] for line in block)
    if lines and not _NOTICE.search(comment):
        return "could not find copyright notice"
    known = any(each in " ".join(comment.split()) for each in _LICENSES)
    return "" if known or not lines else "license=<unknown>"
