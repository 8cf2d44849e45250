"""What a desktop in virtual time does by the world's time: so it comes at the same moments of it, however fast that passes."""

from __future__ import annotations

import asyncio
import contextvars
import threading
import time
from collections.abc import Callable


def each(seconds: float, act: Callable[[], bool]) -> None:
    """Call `act` in the event loop each time so many seconds of the world have passed, until it returns False.

    Time passes only when everybody waits, so the world stands still while it is called. Call this in the event loop.
    """
    loop, context = asyncio.get_running_loop(), contextvars.copy_context()
    goes_on = True

    def once() -> None:
        nonlocal goes_on
        goes_on = act()

    def keep_calling() -> None:
        while goes_on:
            time.sleep(seconds)
            try:
                loop.call_soon_threadsafe(once, context=context)
            except RuntimeError:  # the loop was closed
                return

    threading.Thread(target=keep_calling, name="day6-world-ticks", daemon=True).start()
