"""Folders whose names leave room for a socket's: 104 bytes are all that some systems allow for both."""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

_SHORTEST = "/tmp"
"""Where POSIX has temporary files; what TMPDIR names may be long."""


_made: list[Path] = []


def make_short_folder(prefix: str = "d6-") -> Path:
    """Make an empty folder that only this user may enter; at the latest the end of the run removes it."""
    usable = os.name == "posix" and os.access(_SHORTEST, os.W_OK | os.X_OK)
    folder = Path(tempfile.mkdtemp(prefix=prefix, dir=_SHORTEST if usable else None)).resolve()
    _made.append(folder)
    return folder


def remove_short_folders() -> None:
    """Remove what this process has made and what is left of it."""
    while _made:
        shutil.rmtree(_made.pop(), ignore_errors=True)
