"""The robots that come with day6-tui."""

from __future__ import annotations

import errno
import os
from pathlib import Path

_MODELS = Path(__file__).resolve().parent / "models"


def shipped_model(name: str = "day6_bot") -> Path:
    """Return the URDF file of a shipped robot ('day6_bot', with or without '.urdf').

    Raises:
        KeyError: there is no such robot.
    """
    stem = name.removesuffix(".urdf")
    if stem not in shipped_models():
        raise KeyError(name)
    return _MODELS / f"{stem}.urdf"


def shipped_models() -> list[str]:
    """Return the names of the shipped robots, sorted."""
    return sorted(path.stem for path in _MODELS.glob("*.urdf"))


def copy_model(folder: Path, name: str = "day6_bot") -> Path:
    """Copy a shipped robot into a folder, where its path is short to type, and return the path.

    An existing file of that name is left as it is: it may be somebody's work.

    Raises:
        KeyError: there is no such robot.
        OSError: the copy cannot be written; no part of it is left.
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
            copy.unlink()  # next time a partial copy would be taken for somebody's work
            raise
    return copy
