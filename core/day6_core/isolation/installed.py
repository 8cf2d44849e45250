"""Where programs are read from: the system's folders, and those of our Python and of this package."""

from __future__ import annotations

import os
import sys
from importlib.util import find_spec
from pathlib import Path

SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/etc", "/opt", "/nix/store")


PACKAGES = ("day6_core", "day6_tui", "day6_urdf")


def folders() -> list[str]:
    """Return the folders that programs in a cell must be able to read; those in others are left out."""
    ours = (path.parent for name in PACKAGES if (path := _folder(name)))
    python = {sys.prefix, sys.base_prefix, os.path.dirname(os.path.dirname(os.path.realpath(sys.executable)))}
    packages = (path for path in sys.path if os.path.basename(path) in ("site-packages", "dist-packages"))
    wanted = {*SYSTEM, *python, *map(str, ours), *packages}
    found = sorted(os.path.abspath(path) for path in wanted if os.path.exists(path))
    return [path for path in found if not any(path.startswith(other + "/") for other in found)]


def _folder(package: str) -> Path | None:
    """Return where a package of ours is: all are in one folder if they are installed, each in its own of a checkout."""
    spec = find_spec(package)
    return Path(spec.origin).resolve().parent if spec is not None and spec.origin is not None else None


def is_below(path: Path, folder: str) -> bool:
    """Return whether `path` is `folder` or in it."""
    return path == Path(folder) or Path(folder) in path.parents
