"""An event loop in a thread, so that tests without `await` can talk to a browser and to a server."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Coroutine
from typing import Any, TypeVar

from tests.support.waiting import PATIENCE
from tests.web.in_time import in_time

T = TypeVar("T")


class Background:
    """Runs coroutines one call at a time for a caller that waits, with a bound."""

    def __init__(self) -> None:
        self.loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self.loop.run_forever, name="background loop", daemon=True)
        self._thread.start()

    def run(self, coroutine: Coroutine[Any, Any, T], seconds: float = PATIENCE) -> T:
        """The coroutine's result. Raises TimeoutError."""
        return asyncio.run_coroutine_threadsafe(in_time(coroutine, seconds), self.loop).result()

    def close(self) -> None:
        self.loop.call_soon_threadsafe(self.loop.stop)
        self._thread.join(5)
        self.loop.close()
