"""What every filter is."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class SimpleFilter:
    """Base of all filters: passes messages on to its registered callbacks."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = {}

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:
        """Call `cb(message…, *args)` for every output of this filter. Returns the connection's number."""
        connection = len(self.callbacks)
        self.callbacks[connection] = (cb, args)
        return connection

    def unregisterCallback(self, conn: int) -> None:
        """Forget the callback of a connection."""
        self.callbacks.pop(conn, None)

    def signalMessage(self, *msg: Any) -> None:
        """Pass messages on."""
        for callback, args in list(self.callbacks.values()):
            callback(*msg, *args)
