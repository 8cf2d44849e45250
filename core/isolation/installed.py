"""Where programs are read from: the system's folders, and those of our Python and of this package."""

from __future__ import annotations

import os
import sys
from pathlib import Path

SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/etc", "/opt", "/nix/store")


def folders() -> list[str]:
    """Return the folders that programs in a cell must be able to read; those in others are left out."""
    package = Path(__file__).resolve().parents[2]
    python = {sys.prefix, sys.base_prefix, os.path.dirname(os.path.dirname(os.path.realpath(sys.executable)))}
    packages = (path for path in sys.path if os.path.basename(path) in ("site-packages", "dist-packages"))
    wanted = {*SYSTEM, *python, str(package), *packages}
    found = sorted(os.path.abspath(path) for path in wanted if os.path.exists(path))
    return [path for path in found if not any(path.startswith(other + "/") for other in found)]


def is_below(path: Path, folder: str) -> bool:
    """Return whether `path` is `folder` or in it."""
    return path == Path(folder) or Path(folder) in path.parents
