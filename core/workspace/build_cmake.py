"""Packages with a CMakeLists.txt: those with messages are built, of the others only what needs no compiler."""

from __future__ import annotations

from day6_tui.core.workspace.jobs import Work
from day6_tui.core.workspace.packages import Package
from day6_tui.core.workspace.settings import Settings


def build(package: Package, settings: Settings, work: Work) -> int:
    """Build one package; returns an exit status."""
    work.stderr(f"day6-tui has no C++ compiler: '{package.name}' was not built\n")
    return 1
