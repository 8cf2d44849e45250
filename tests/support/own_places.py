"""What a recording may not tell: where it was made."""

from __future__ import annotations

import os
import platform
import re
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def own_places(text: str) -> list[str]:
    """Return the folders and the name of this machine that a text mentions, and any folder of root's or of a Python's."""
    own = (str(ROOT), sys.prefix, os.path.expanduser("~"), tempfile.gettempdir(), platform.node())
    return [
        place
        for place in (*own, "/root/", "/tmp/", ".venv", ".pyenv")
        if re.search(rf"(?<![\w/]){re.escape(place)}\b", text)
    ]
