"""Waits for several things to be ready."""

from __future__ import annotations

import threading
from collections.abc import Callable


class ReadyAggregator:
    """Calls a function when its own `ready_fn` has been called `num_to_aggregate` times, from whatever threads."""

    def __init__(self, ready_fn: Callable[[], object], num_to_aggregate: int) -> None:
        self._parent_ready_fn = ready_fn
        self._left = num_to_aggregate
        self._lock = threading.Lock()

    def ready_fn(self) -> None:
        with self._lock:
            self._left -= 1
            is_last = self._left == 0
        if is_last:
            self._parent_ready_fn()
