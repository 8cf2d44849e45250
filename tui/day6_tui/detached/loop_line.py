"""A line of `wire` in an event loop: what the peer does not take at once is sent when it does."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

from day6_tui.detached.wire import Connection


class LoopLine(Connection):
    """Use it in the event loop only."""

    def __init__(self, connection: socket.socket) -> None:
        super().__init__(connection)
        self._loop: asyncio.AbstractEventLoop | None = None
        """Where somebody waits for it."""

    def on_readable(self, hear: Callable[[], object] | None) -> None:
        """Call this when there is something to `receive`; None for nothing."""
        loop = self._loop = asyncio.get_running_loop()
        if hear is not None:
            loop.add_reader(self.fileno(), hear)
        else:
            loop.remove_reader(self.fileno())

    def send(self, kind: bytes, data: bytes = b"") -> None:
        """Send this, as soon as the peer takes it."""
        super().send(kind, data)
        if self.unsent:
            self._loop = asyncio.get_running_loop()
            self._loop.add_writer(self.fileno(), self._go_on)

    def _go_on(self) -> None:
        self.flush()
        if not self.unsent and self._loop is not None:
            self._loop.remove_writer(self.fileno())

    def let_go(self) -> None:
        """Wait for nothing any more, and stay open."""
        if self._loop is not None and self.fileno() >= 0:
            self._loop.remove_reader(self.fileno())
            self._loop.remove_writer(self.fileno())
        self._loop = None

    def close(self) -> None:
        self.let_go()
        super().close()
