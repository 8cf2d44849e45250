"""Pupils beside those in a real browser: each has a tab that takes what it is sent, and comes back as our page does."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections.abc import Iterable

import aiohttp

from tests.web.serving import browser

AGAIN_SECONDS = 1.0
"""Before a tab that lost its server tries again."""


class Crowd:
    """They come as soon as this is made, by their links, and go with `close`."""

    def __init__(self, base: str, links: Iterable[str]) -> None:
        self._base = base
        self._loop = asyncio.new_event_loop()
        self._pupils = [self._loop.create_task(self._attend(link)) for link in links]
        ended = asyncio.wait(self._pupils) if self._pupils else asyncio.sleep(0)
        self._thread = threading.Thread(target=self._loop.run_until_complete, args=(ended,), name="crowd", daemon=True)
        self._thread.start()

    def close(self) -> None:
        for pupil in self._pupils:
            self._loop.call_soon_threadsafe(pupil.cancel)
        self._thread.join()

    async def _attend(self, link: str) -> None:
        async with browser(self._base) as door:
            await door.get(link)
            while True:
                with contextlib.suppress(aiohttp.ClientError):  # no server
                    await self._look(door.session, door.origin)
                await asyncio.sleep(AGAIN_SECONDS)

    async def _look(self, session: aiohttp.ClientSession, headers: dict[str, str]) -> None:
        address, got = f"{self._base}ws?cols=120&rows=40&w=0&h=0", 0
        async with session.ws_connect(address, headers=headers, max_msg_size=0) as ws:
            async for message in ws:
                if message.type == aiohttp.WSMsgType.BINARY:
                    got += len(message.data)
                    await ws.send_json({"t": "ack", "bytes": got})
