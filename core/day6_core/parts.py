"""Packages of others that day6-tui can be installed without. What needs one that is missing says so in one sentence."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import Any

PROJECTS = {
    "PIL": "pillow",
    "lz4": "lz4",
    "reportlab": "reportlab",
    "zenoh": "eclipse-zenoh",
    "zstandard": "zstandard",
}
"""The project that brings a package. requirements/desktop.txt is without them (.ci/pins)."""


class MissingPart(OSError):
    """A package is needed that isn't installed; the message says for what, and how it is installed."""


def part(package: str, purpose: str) -> Any:
    """Import one of these packages, or a module of it; `purpose` is what needs it: "zstd-compressed bags need".

    Raises:
        MissingPart: it isn't installed.
    """
    top = package.partition(".")[0]
    try:
        import_module(top)
        return import_module(package)
    except ModuleNotFoundError as error:
        if error.name != top:  # it is installed, and what it needs is not
            raise
        project = PROJECTS[top]
        raise MissingPart(f"{purpose} {project}, which isn't installed: pip install {project}") from None


def has_part(package: str) -> bool:
    """Return whether a package is installed, without importing it."""
    try:
        return find_spec(package) is not None
    except ValueError:  # sys.modules says that it isn't
        return False
