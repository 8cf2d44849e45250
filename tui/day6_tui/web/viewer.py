"""One browser tab that looks at a desktop: what goes to it, and how much of that it has taken."""

from __future__ import annotations

import asyncio
import contextlib
import json
from collections.abc import Callable
from typing import Any

from aiohttp import web

MOST_UNACKNOWLEDGED = 256 << 10
"""Bytes that may be on their way: more, and the desktop draws fewer frames, as on any slow terminal."""

MOST_WAITING = 4 << 20
"""Bytes that wait here at most for one that only watches, whom the desktop does not wait for."""

PIECE = 32 << 10


class Viewer:
    """A socket. `cols`, `rows`, `width` and `height` are those of the tab."""

    def __init__(self, ws: web.WebSocketResponse, size: tuple[int, int, int, int], *, read_only: bool) -> None:
        self._ws = ws
        self.size = size
        self.read_only = read_only
        self._waiting = bytearray()
        self._sent = 0
        self._acknowledged = 0
        self._wakes = asyncio.Event()
        self._follows: tuple[int, int] | None = None
        """Columns and rows that it has yet to be told of."""
        self._last: dict[str, Any] | None = None
        """The last words; set when it is over."""
        self.on_room: Callable[[], None] | None = None
        """Called when there is room again."""

    @property
    def is_full(self) -> bool:
        """Whether it has to acknowledge something first."""
        return self._sent + len(self._waiting) - self._acknowledged >= MOST_UNACKNOWLEDGED

    @property
    def is_over(self) -> bool:
        """Whether it was said goodbye to."""
        return self._last is not None

    @property
    def is_lost(self) -> bool:
        """Whether far too much waits."""
        return len(self._waiting) > MOST_WAITING

    def put(self, data: bytes) -> None:
        """Output of the desktop."""
        if self._last is None:
            self._waiting += data
            self._wakes.set()

    def follow(self, columns: int, rows: int) -> None:
        """The screen it watches has this size."""
        self._follows = columns, rows
        self._wakes.set()

    def acknowledge(self, total: int) -> None:
        """The browser has shown so many bytes."""
        if self._acknowledged < total <= self._sent:
            self._acknowledged = total
            self._wakes.set()

    async def say(self, **words: Any) -> None:
        """Send a message beside the output."""
        if not self._ws.closed:
            with contextlib.suppress(ConnectionError):
                await self._ws.send_str(json.dumps(words))

    def bye(self, why: str) -> None:
        """Close, after what waits was sent, as far as there is room."""
        if self._last is None:
            self._last = {"t": "bye", "why": why}
            self._wakes.set()

    async def run(self) -> str:
        """Send until it is over, and return why it is. Closing is left to whoever reads from the socket."""
        while self._last is None:
            if self._follows is not None:
                (columns, rows), self._follows = self._follows, None
                await self.say(t="size", cols=columns, rows=rows)
            room = MOST_UNACKNOWLEDGED - (self._sent - self._acknowledged)
            piece = bytes(self._waiting[: min(PIECE, room)]) if room > 0 else b""
            if piece:
                await self._send(piece)
            else:
                self._wakes.clear()
                await self._wakes.wait()
        room = MOST_UNACKNOWLEDGED - (self._sent - self._acknowledged)
        if self._waiting and room > 0:
            await self._send(bytes(self._waiting[:room]))
        await self.say(**self._last)
        return str(self._last["why"])

    async def _send(self, piece: bytes) -> None:
        del self._waiting[: len(piece)]
        self._sent += len(piece)
        await self._ws.send_bytes(piece)
        if self.on_room is not None and not self.is_full:
            self.on_room()
