"""A server for the pages that does what a test says: it serves the static files and speaks the protocol of one WebSocket."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from aiohttp import WSMsgType, web

from day6_tui import web as door
from day6_tui.locale import Texts
from day6_tui.web import pages
from tests.support.waiting import until
from tests.web.background import Background

T = TypeVar("T")

STATIC = Path(door.__file__).parent / "static"
POLICY = (
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:;"
    " object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'"
)


class PageServer:
    """Answers at `address`; remembers what the page sent."""

    def __init__(self, background: Background) -> None:
        self._background = background
        self.hello: dict[str, Any] = {"t": "hello", "name": "anna", "read_only": False, "lang": "en"}
        self.farewell: str | None = None
        """Why a new connection is said goodbye to at once; None: it is not."""
        self.refuses = False
        self.is_mute = False
        """Whether it takes connections and never answers: a network that was cut somewhere on the way."""
        self.pongs = True
        self.connections: list[Mapping[str, str]] = []
        """What the addresses of the WebSockets said."""
        self.forget()
        self._socket: web.WebSocketResponse | None = None
        self._shown: web.WebSocketResponse | None = None
        self.address = background.run(self._start())

    def forget(self) -> None:
        """Begin anew with what the page sends."""
        self.keys = b""
        self.messages: list[dict[str, Any]] = []

    async def _start(self) -> str:
        app = web.Application()
        app.router.add_get("/below/desk", self._page("desk.html"))
        app.router.add_get("/below/class", self._page("class.html"))
        app.router.add_get("/below/ws", self._line)
        app.router.add_get("/below/class/ws", self._line)
        app.router.add_get("/below/shown", self._show)
        app.router.add_get("/below/manifest.webmanifest", self._manifest)
        app.router.add_static("/below/static", STATIC)
        app.on_response_prepare.append(_with_policy)
        self._runner = web.AppRunner(app, shutdown_timeout=0.1)
        await self._runner.setup()
        site = web.TCPSite(self._runner, "127.0.0.1", 0)
        await site.start()
        return f"http://127.0.0.1:{self._runner.addresses[0][1]}/below"

    async def _manifest(self, request: web.Request) -> web.Response:
        return pages.manifest(Texts("en"), request.query["start"])

    def _page(self, name: str) -> Any:
        async def page(request: web.Request) -> web.StreamResponse:
            await self._be_mute()
            return web.Response(status=401) if self.refuses else web.FileResponse(STATIC / name)

        return page

    async def _line(self, request: web.Request) -> web.WebSocketResponse:
        await self._be_mute()
        if self.refuses:
            raise web.HTTPUnauthorized
        socket = web.WebSocketResponse()
        await socket.prepare(request)
        self.connections.append(dict(request.query))
        if self.farewell is not None:
            await socket.send_json({"t": "bye", "why": self.farewell})
            await socket.close()
            return socket
        await socket.send_json(self.hello)
        self._socket = socket
        async for frame in socket:
            await self._take(socket, frame)
        return socket

    async def _be_mute(self) -> None:
        if self.is_mute:
            while self.is_mute:
                await asyncio.sleep(0.05)
            raise web.HTTPServiceUnavailable  # nobody waits for it any more

    async def _show(self, request: web.Request) -> web.WebSocketResponse:
        """The line on which the pictures of another screen come."""
        self._shown = socket = web.WebSocketResponse()
        await socket.prepare(request)
        await socket.send_json({"t": "hello"})
        async for frame in socket:
            await self._take(socket, frame)
        self._shown = None
        return socket

    @property
    def is_looked_at(self) -> bool:
        """Whether the page looks at another screen."""
        return self._shown is not None

    def picture(self, *lines: str, columns: int = 40, rows: int = 5) -> None:
        """Send lines of the other screen, the first ones."""
        self.wait_for(lambda: self.is_looked_at)
        assert self._shown is not None
        told = {"t": "screen", "columns": columns, "rows": rows, "lines": dict(enumerate(lines))}
        self._background.run(self._shown.send_json(told))

    async def _take(self, socket: web.WebSocketResponse, frame: Any) -> None:
        if frame.type == WSMsgType.BINARY:
            self.keys += frame.data
        elif frame.type == WSMsgType.TEXT:
            message = json.loads(frame.data)
            self.messages.append(message)
            if message["t"] == "ping" and self.pongs:
                await socket.send_json({"t": "pong", "n": message["n"]})

    def output(self, data: bytes | str) -> None:
        """Send the terminal something."""
        data = data.encode() if isinstance(data, str) else data
        assert self._socket is not None
        self._background.run(self._socket.send_bytes(data))

    def say(self, message: Mapping[str, Any]) -> None:
        """Send the page a message."""
        assert self._socket is not None
        self._background.run(self._socket.send_json(message))

    def hang_up(self) -> None:
        """Drop the line without a word."""
        self._background.run(self._drop())

    async def _drop(self) -> None:
        if self._socket is not None and (transport := self._socket._req.transport if self._socket._req else None):
            transport.abort()
        await asyncio.sleep(0)

    def of_kind(self, kind: str) -> list[dict[str, Any]]:
        """What the page said of one kind."""
        return [message for message in self.messages if message["t"] == kind]

    def wait_for(self, condition: Callable[[], T]) -> T:
        """The condition's value as soon as it is true."""
        return until(condition, told=lambda: f"keys {self.keys!r}, messages {self.messages[-5:]!r}")

    def wait_for_keys(self, expected: bytes) -> None:
        """Wait until the page sent just these keys since the last `forget`."""
        until(lambda: expected in self.keys, told=lambda: f"{expected!r} is not in {self.keys!r}")

    def close(self) -> None:
        self.is_mute = False
        self._background.run(self._runner.cleanup())


async def _with_policy(request: web.Request, response: web.StreamResponse) -> None:
    response.headers["Content-Security-Policy"] = POLICY
