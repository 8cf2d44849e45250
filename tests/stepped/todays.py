"""A third of many long cases, another third each day: all of them every day would take the suite beyond its time.

`DAY6_TESTS_ALL=1` runs them all, as before a release.
"""

from __future__ import annotations

import datetime
import os
from collections.abc import Sequence
from typing import TypeVar

T = TypeVar("T")
PARTS = 3


def today() -> int:
    """The number of this day (UTC)."""
    return datetime.datetime.now(datetime.timezone.utc).toordinal()


def todays(cases: Sequence[T]) -> list[T]:
    """The cases of today, or all."""
    if os.environ.get("DAY6_TESTS_ALL"):
        return list(cases)
    return list(cases[today() % PARTS :: PARTS])
