"""Waiting in coroutines, on the clock of `waiting.Deadline`."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
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


async def eventually(condition: Callable[[], T], told: Callable[[], object] = lambda: None) -> T:
    """The condition's value as soon as it is true; `told` says more where it does not become so."""
    deadline = Deadline()
    while not (found := condition()):
        assert not deadline.is_over(), told()
        await asyncio.sleep(LOOK_SECONDS / 10)
    return found
