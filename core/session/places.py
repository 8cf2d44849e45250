"""Where day6-tui keeps what belongs to this user."""

from __future__ import annotations

import os
import sys
from pathlib import Path


def data_folder() -> Path:
    """The folder of this user for all that lasts: the simulated home, copies of unsaved texts, stubs. It may not exist yet."""
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Application Support"
    else:
        base = Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share")
    return base / "day6-tui"


def default_home() -> Path:
    """The folder that is `~` on the simulated machine unless `--home` says otherwise."""
    return data_folder() / "home"
