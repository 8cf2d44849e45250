"""The robots that come with day6-tui."""

from __future__ import annotations

import errno
import os
from pathlib import Path

_MODELS = Path(__file__).resolve().parent / "models"


def shipped_model(name: str = "day6_bot") -> Path:
    """Return the URDF file of a shipped robot ('day6_bot', with or without '.urdf'). Raises KeyError."""
    stem = name.removesuffix(".urdf")
    if stem not in shipped_models():
        raise KeyError(name)
    return _MODELS / f"{stem}.urdf"


def shipped_models() -> list[str]:
    """Return the names of the shipped robots, sorted."""
    return sorted(path.stem for path in _MODELS.glob("*.urdf"))


def copy_model(folder: Path, name: str = "day6_bot") -> Path:
    """Put a copy of a shipped robot into a folder, where it is short to type, and return it.

    A file of that name that is there already stays as it is: it may be somebody's work. Raises KeyError, OSError.
    """
    copy = folder / shipped_model(name).name
    if copy.exists():
        return copy
    data = shipped_model(name).read_bytes()
    with copy.open("xb", buffering=0) as file:
        try:
            if file.write(data) != len(data):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(copy))
        except OSError:
            copy.unlink()  # half a robot would be taken for somebody's work the next time
            raise
    return copy
