"""Tabs of a real `day6-tui serve`, for `class.py --serve`: no browser, but the same WebSocket, acknowledged as a browser does."""

from __future__ import annotations

import asyncio
import concurrent.futures
import os
import re
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Coroutine, Iterator
from pathlib import Path
from typing import Any

import aiohttp

from day6_tui.detached import wire

WORD = "class"
PATIENCE = 180.0
"""Seconds after which something counts as too slow."""


class TooSlow(Exception):
    """Something took longer than PATIENCE; the message says what."""


class Server:
    """`day6-tui serve` on a free port, and the event loop of its tabs."""

    def __init__(self, place: Path) -> None:
        words = [
            "serve",
            "--word",
            WORD,
            "--unasked",
            "1000",  # all come from this machine
            "--port",
            "0",
            "--data",
            str(place / "class"),
            "--isolation",
            "none",
            "--lang",
            "en",
        ]
        self.homes = place / "class" / "homes"
        self.process = subprocess.Popen(
            [sys.executable, "-m", "day6_tui.main", *words],
            stdout=subprocess.PIPE,
            encoding="utf-8",
            start_new_session=True,  # the tabs' share of the processors is not the server's
            env={**os.environ, "DAY6_RUNTIME_DIR": str(place / "run")},
        )
        assert self.process.stdout is not None
        self.base = next(found[1] for line in self.process.stdout if (found := re.search(r"open (http\S+) in", line)))
        self.loop = asyncio.new_event_loop()
        threading.Thread(target=self.loop.run_forever, daemon=True).start()

    def cpu_seconds(self) -> float:
        """What the server itself has used."""
        tasks = Path(f"/proc/{self.process.pid}/task").iterdir()
        return sum(int((task / "schedstat").read_text(encoding="ascii").split()[0]) / 1e9 for task in tasks)

    def close(self) -> bool:
        """End it, with all its desktops; False if it had to be killed."""
        self.process.send_signal(signal.SIGTERM)
        try:
            self.process.communicate(timeout=PATIENCE)
            return True
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.communicate()
            return False
        finally:
            self.loop.call_soon_threadsafe(self.loop.stop)


class Tab:
    """A pupil's tab, with what `class.py` uses of a keeper's line."""

    def __init__(self, server: Server, name: str) -> None:
        self._server = server
        self._ours, self._theirs = socket.socketpair()
        self._ours.setblocking(False)
        self._session: aiohttp.ClientSession | None = None
        self._name = name
        self.reload()

    def reload(self) -> None:
        """Open the desktop again, as the browser's reload does."""
        self._run("opens the desktop", self._open())

    async def _open(self) -> None:
        base = self._server.base
        if self._session is None:
            self._session = aiohttp.ClientSession(cookie_jar=aiohttp.CookieJar(unsafe=True))
            form = {"word": WORD, "name": self._name}
            async with self._session.post(f"{base}enter", data=form, headers={"Origin": base[:-1]}) as answer:
                answer.raise_for_status()
        else:
            await self._ws.close()
        self._ws = await self._session.ws_connect(f"{base}ws?cols=120&rows=40", headers={"Origin": base[:-1]})
        self._reading = asyncio.create_task(self._read(self._ws))

    async def _read(self, ws: aiohttp.ClientWebSocketResponse) -> None:
        taken = 0
        async for message in ws:
            if message.type == aiohttp.WSMsgType.BINARY:
                taken += len(message.data)
                await asyncio.get_running_loop().sock_sendall(self._theirs, message.data)
                await ws.send_json({"t": "ack", "bytes": taken})

    def _run(self, what: str, coroutine: Coroutine[Any, Any, None]) -> None:
        deed = asyncio.run_coroutine_threadsafe(coroutine, self._server.loop)
        try:
            deed.result(PATIENCE)
        except concurrent.futures.TimeoutError:
            deed.cancel()
            raise TooSlow(f"{self._name} {what}: not within {PATIENCE:.0f} s") from None

    def fileno(self) -> int:
        """What becomes readable with output."""
        return self._ours.fileno()

    def receive(self) -> Iterator[tuple[bytes, bytes]]:
        """The output that has come."""
        try:
            yield wire.OUTPUT, self._ours.recv(1 << 16)
        except BlockingIOError:
            return

    def send(self, kind: bytes, data: bytes) -> None:
        """Type."""
        assert kind == wire.INPUT
        self._run("types", self._ws.send_bytes(data))

    def close(self) -> None:
        """Close the tab; the desktop stays."""
        self._run("leaves", self._leave())

    async def _leave(self) -> None:
        assert self._session is not None
        await self._ws.close()
        await self._session.close()
