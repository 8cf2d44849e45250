"""The folders in which day6-tui keeps this user's data."""

from __future__ import annotations

import os
import sys
from pathlib import Path


def data_folder() -> Path:
    """Return the folder of this user's lasting data: the simulated home, copies of unsaved texts, stubs. It may not exist."""
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Application Support"
    else:
        base = Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share")
    return base / "day6-tui"


def default_home() -> Path:
    """Return the folder that is `~` on the simulated machine without `--home`."""
    return data_folder() / "home"
