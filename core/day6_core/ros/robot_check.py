"""Robot descriptions by the rules of this distribution's urdfdom."""

from __future__ import annotations

from day6_core.ros import differences
from day6_urdf.check import check_text
from day6_urdf.report import Report


def newest_urdf() -> tuple[int, int]:
    """Return the newest version of URDF that is read."""
    newest: tuple[int, int] = differences.value("urdf.newest")
    return newest


def check_robot(text: str) -> Report:
    """Check a description, as `check_text`."""
    return check_text(text, newest_urdf())
