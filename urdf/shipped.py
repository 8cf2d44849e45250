"""The robots that come with day6-tui."""

from __future__ import annotations

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
    if not copy.exists():
        copy.write_bytes(shipped_model(name).read_bytes())
    return copy
