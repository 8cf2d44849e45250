"""Folders whose names leave room for a socket's: 104 bytes are all that some systems allow for both."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

_SHORTEST = "/tmp"
"""Where POSIX has temporary files; what TMPDIR names may be long."""


def make_short_folder(prefix: str = "d6-") -> Path:
    """Make an empty folder that only this user may enter; who makes it removes it."""
    usable = os.name == "posix" and os.access(_SHORTEST, os.W_OK | os.X_OK)
    return Path(tempfile.mkdtemp(prefix=prefix, dir=_SHORTEST if usable else None)).resolve()
