"""Waiting with a limit that never loses a cancellation, and the end of tasks.

`asyncio.wait_for` loses it before Python 3.12, if what is waited for ends just then: the task goes on, and whoever waits for its
end waits for ever.
"""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from typing import Any, TypeVar

T = TypeVar("T")


async def in_time(deed: Coroutine[Any, Any, T], seconds: float) -> T:
    """Return what comes of it. Raises asyncio.TimeoutError, and ends it, if it is not done in time."""
    task = asyncio.create_task(deed)
    try:
        if not (await asyncio.wait({task}, timeout=seconds))[0]:
            raise asyncio.TimeoutError
        return task.result()
    finally:
        await stop(task)


async def stop(*tasks: asyncio.Task[Any]) -> None:
    """Cancel tasks and wait until they have ended, whatever comes of them."""
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)
