"""The folder this process works in, also when somebody has removed it."""

from __future__ import annotations

import os
import sys
from pathlib import Path

LOST = "error retrieving current directory: getcwd: cannot access parent directories: No such file or directory"
"""What bash says of a folder that is gone (builtins/common.def)."""


def working_folder() -> Path:
    """Return the current folder; where that is gone a path in which nothing is found and nothing can be made.

    Not the path it had: making a folder there would bring it back for everybody but this process.
    """
    try:
        return Path.cwd()
    except OSError:
        return Path("/proc/self/cwd" if sys.platform == "linux" else os.path.join(os.devnull, "gone"))
