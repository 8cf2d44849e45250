"""The working folder of this process, even after it has been removed."""

from __future__ import annotations

import os
import sys
from pathlib import Path

LOST = "error retrieving current directory: getcwd: cannot access parent directories: No such file or directory"
"""Bash's message for a working folder that is gone (builtins/common.def)."""


def working_folder() -> Path:
    """Return the current folder; if it is gone, a path in which nothing is found and nothing can be created.

    Not its old path: creating a folder there would bring it back for every process except this one.
    """
    try:
        return Path.cwd()
    except OSError:
        return Path("/proc/self/cwd" if sys.platform == "linux" else os.path.join(os.devnull, "gone"))
