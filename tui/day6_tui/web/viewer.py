"""One browser tab that looks at a desktop: what goes to it, and how much of that it has taken."""

from __future__ import annotations

import asyncio
import contextlib
import json
import time
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from aiohttp import web

if TYPE_CHECKING:
    from day6_tui.web.session import WebSession

MOST_UNACKNOWLEDGED = 256 << 10
"""Bytes that may be on their way: more, and the desktop draws fewer frames, as on any slow terminal."""

UNTOLD = 32 << 10
"""Bytes that a page has shown and not yet acknowledged at most (connection.js)."""

STALE_SECONDS = 0.5
"""A tab that has not shown for so long what it was sent gets no more before it has: what a key does would wait behind it."""

MOST_WAITING = 4 << 20
"""Bytes that wait here at most for one that only watches, whom the desktop does not wait for."""

PIECE = 32 << 10


class Viewer:
    """A socket. `cols`, `rows`, `width` and `height` are those of the tab; `lang` is the language of its page."""

    def __init__(
        self, ws: web.WebSocketResponse, size: tuple[int, int, int, int], *, read_only: bool, lang: str
    ) -> None:
        self._ws = ws
        self.size = size
        self.read_only = read_only
        self.lang = lang
        self._waiting = bytearray()
        self._sent = 0
        self._acknowledged = 0
        self._on_way: deque[tuple[int, float]] = deque()
        """Of what it must acknowledge, oldest first: the number of bytes sent until then, and when."""
        self._wakes = asyncio.Event()
        self._news: dict[str, dict[str, Any]] = {}
        """What it has yet to be told, the newest of each kind."""
        self.session: WebSession | None = None
        """The desktop it looks at; None while that is being started."""
        self.early = bytearray()
        """Keys that came before there was a desktop."""
        self._last: dict[str, Any] | None = None
        """The last words; set when it is over."""
        self.on_room: Callable[[], None] | None = None
        """Called when there is room again."""

    @property
    def is_full(self) -> bool:
        """Whether it has to acknowledge something first."""
        if self._sent + len(self._waiting) - self._acknowledged >= MOST_UNACKNOWLEDGED:
            return True
        return bool(self._on_way) and time.monotonic() - self._on_way[0][1] > STALE_SECONDS

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
        self._tell(t="size", cols=columns, rows=rows)

    def expect(self, before: int) -> None:
        """Its desktop is being started, after that of so many others."""
        self._tell(t="starting", before=before)

    def _tell(self, **words: Any) -> None:
        self._news[words["t"]] = words
        self._wakes.set()

    def acknowledge(self, total: int) -> None:
        """The browser has shown so many bytes."""
        if self._acknowledged < total <= self._sent:
            self._acknowledged = total
            self._forget_shown()
            self._wakes.set()
            if self.on_room is not None and not self.is_full:
                self.on_room()

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
            while self._news:
                await self.say(**self._news.pop(next(iter(self._news))))
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
        self._on_way.append((self._sent, time.monotonic()))
        self._forget_shown()
        await self._ws.send_bytes(piece)

    def _forget_shown(self) -> None:
        while self._on_way and self._on_way[0][0] <= self._acknowledged + UNTOLD:
            self._on_way.popleft()
