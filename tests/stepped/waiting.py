"""Waiting for what real processes and threads do: look again and again, until a deadline that only a defect reaches."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")

PATIENCE = 30.0
"""Wall seconds something may take on a machine that has a lot else to do; nothing waits that long unless it is broken."""


def until(
    condition: Callable[[], T],
    limit: float = PATIENCE,
    *,
    every: float = 0.005,
    meanwhile: Callable[[], object] | None = None,
    told: Callable[[], object] | None = None,
) -> T:
    """Ask until the answer is true and return it; AssertionError, with what `told` returns, when it never is.

    Between two looks `meanwhile` is called (it moves a stepped clock on, or runs a scheduler), and then `every` seconds pass.
    """
    end = time.monotonic() + limit
    while not (answer := condition()):
        if time.monotonic() > end:
            raise AssertionError(f"after {limit} s the answer is still {answer!r}; {told() if told else ''}")
        if meanwhile is not None:
            meanwhile()
        time.sleep(every)
    return answer


def never(condition: Callable[[], object], seconds: float, *, every: float = 0.005) -> bool:
    """Say whether the answer stayed false for so long."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return True
        time.sleep(every)
    return False
