"""Waiting in coroutines, on the clock of `waiting.Deadline`."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from typing import Any, TypeVar

from tests.support.waiting import PATIENCE, Deadline

T = TypeVar("T")

LOOK_SECONDS = 0.05


async def in_time(deed: Coroutine[Any, Any, T], limit: float = PATIENCE) -> T:
    """The deed's result. Raises TimeoutError, and ends the deed, when the deadline is over."""
    task, deadline = asyncio.create_task(deed), Deadline(limit)
    try:
        while not (await asyncio.wait([task], timeout=LOOK_SECONDS))[0]:
            if deadline.is_over():
                raise TimeoutError(f"not done in {limit} s: {deed.__qualname__}")
        return task.result()
    finally:
        if not task.done():
            task.cancel()
            await asyncio.wait([task])
