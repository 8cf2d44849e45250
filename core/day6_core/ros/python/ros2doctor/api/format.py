"""How reports and warnings are printed."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

from day6_core.ros.ros2.doctor import report_lines

if TYPE_CHECKING:
    from ros2doctor.api import Report


def format_print(report: Report) -> None:
    """Print a report."""
    print(*report_lines(report.name, report.items), sep="\n")


def doctor_warn(msg: str) -> None:
    """Warn of something that does not fail a check."""
    warnings.warn(msg, stacklevel=2)


def doctor_error(msg: str) -> None:
    """Warn of something that fails a check."""
    warnings.warn(f"ERROR: {msg}", stacklevel=2)
