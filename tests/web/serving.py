"""A server as its user starts it, and browsers' tabs without a browser."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from types import TracebackType
from typing import Any

import pyte
import pytest

from tests.support.waiting import PATIENCE, Deadline
from tests.web.in_time import LOOK_SECONDS, in_time

pytest.importorskip("termios", reason="this system has no pseudo-terminals, and the server no keepers")
pytest.importorskip("aiohttp", reason="needs the extra: pip install 'day6-tui[serve]'")
pytest.importorskip("segno", reason="needs the extra: pip install 'day6-tui[serve]'")

import aiohttp

WORD = "open sesame"


class Serving:
    """`day6-tui serve` on a free port, with a folder of its own."""

    def __init__(
        self, folder: Path, *words: str, python: str = sys.executable, user: dict[str, Any] | None = None
    ) -> None:
        self.folder = folder
        self._python, self._user = python, user or {}
        self._words = [*words, "--port", "0", "--data", str(folder / "class"), "--lang", "en"]
        self.said: list[str] = []
        self.start()

    def start(self, *more: str) -> None:
        environ = {**os.environ, "DAY6_RUNTIME_DIR": str(self.folder / "run"), "SECRET_OF_SERVER": "x31337"}
        environ.pop("DAY6_LINK", None)
        if "users" in self._words:  # for whom a runtime folder of ours is closed
            del environ["DAY6_RUNTIME_DIR"]
        self.process = subprocess.Popen(
            [self._python, "-m", "day6_tui.main", "serve", *self._words, *more],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env=environ,
            cwd="/",
            **self._user,
        )
        self.said = []
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.said.append(line.strip())
            if found := re.search(r"open (http\S+) in a browser", line):
                self.base = found[1]
                return
        raise AssertionError("\n".join(self.said))

    def link(self, name: str) -> str:
        """The link that was printed for a pupil, or for `the teacher`."""
        return next(line.rpartition(" ")[2] for line in self.said if f": {name}: http" in line)

    def end(self, number: int = signal.SIGTERM) -> int:
        self.process.send_signal(number)
        deadline = Deadline()
        while True:
            try:
                rest, _ = self.process.communicate(timeout=LOOK_SECONDS)
            except subprocess.TimeoutExpired:
                assert not deadline.is_over(), "the server does not end"
            else:
                self.said += rest.splitlines()
                return self.process.returncode

    def cells(self) -> list[int]:
        """The processes of this machine that belong to a pupil of this server."""
        mark = os.fsencode(self.folder)
        found = []
        for name in os.listdir("/proc"):
            if name.isdigit() and int(name) not in (os.getpid(), self.process.pid):
                try:
                    words = Path("/proc", name, "cmdline").read_bytes()
                except OSError:
                    continue
                if mark in words and b"day6_tui.main\0serve" not in words:
                    found.append(int(name))
        return found

    def __enter__(self) -> Serving:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self.process.poll() is None:
            self.end()


class Tab:
    """A tab: what the server said, and the screen it shows."""

    def __init__(self, ws: aiohttp.ClientWebSocketResponse, columns: int = 80, rows: int = 24) -> None:
        self.ws = ws
        self.screen = pyte.Screen(columns, rows)
        self._stream = pyte.ByteStream(self.screen)
        self.said: list[dict[str, Any]] = []
        self.got = 0
        self.acknowledges = True

    def text(self) -> str:
        return "\n".join(self.screen.display)

    async def type(self, keys: str) -> None:
        await self.ws.send_bytes(keys.encode())

    @asynccontextmanager
    async def not_idle(self) -> AsyncIterator[None]:
        """Type something all the time that the desktop does not take for a key: that the terminal has the focus."""

        async def type_on() -> None:
            while True:
                await self.type("\x1b[I")
                await asyncio.sleep(0.2)

        typing = asyncio.create_task(type_on())
        try:
            yield
        finally:
            typing.cancel()

    async def hear(self) -> bool:
        """Take one message; False at the end."""
        message = await in_time(self.ws.receive())
        if message.type == aiohttp.WSMsgType.BINARY:
            self.got += len(message.data)
            self._stream.feed(message.data)
            if self.acknowledges:
                with contextlib.suppress(ConnectionError):  # it is about to be closed
                    await self.ws.send_json({"t": "ack", "bytes": self.got})
        elif message.type == aiohttp.WSMsgType.TEXT:
            self.said.append(json.loads(message.data))
        else:
            return False
        return True

    async def see(self, wanted: str | Callable[[str], bool]) -> str:
        """Wait until the screen shows this."""
        deadline = Deadline()
        is_there = (lambda text: wanted in text) if isinstance(wanted, str) else wanted
        while not is_there(self.text()):
            assert not deadline.is_over() and await self.hear(), f"{wanted!r} is not in\n{self.text()}"
        return self.text()

    async def end(self) -> str:
        """Wait for the last word, and return why."""
        while await self.hear():
            pass
        return str(self.said[-1].get("why"))


class Browser:
    """Cookies, and an address that everything is below."""

    def __init__(self, session: aiohttp.ClientSession, base: str) -> None:
        self.session = session
        self.base = base

    @property
    def origin(self) -> dict[str, str]:
        return {"Origin": self.base.rstrip("/")}

    async def get(self, path: str, **headers: str) -> tuple[int, str]:
        address = path if path.startswith("http") else self.base + path
        async with self.session.get(address, headers=headers, allow_redirects=False) as answer:
            return answer.status, await answer.text()

    async def post(self, path: str, origin: str | None = None, **form: str) -> tuple[int, str]:
        headers = self.origin if origin is None else {"Origin": origin}
        async with self.session.post(self.base + path, data=form, headers=headers, allow_redirects=False) as answer:
            return answer.status, await answer.text()

    async def opens(self) -> bool:
        """Whether it is let into a desktop, the only one it could have."""
        async with self.session.get(f"{self.base}desk") as answer:
            return answer.status == 200 and "desk.js" in await answer.text()

    async def tab(self, query: str = "cols=80&rows=24&w=0&h=0", **headers: str) -> Tab:
        ws = await self.session.ws_connect(f"{self.base}ws?{query}", headers={**self.origin, **headers}, max_msg_size=0)
        return Tab(ws)


@asynccontextmanager
async def browser(base: str) -> AsyncIterator[Browser]:
    async with aiohttp.ClientSession(
        cookie_jar=aiohttp.CookieJar(unsafe=True), connector=aiohttp.TCPConnector(limit=0)
    ) as session:
        yield Browser(session, base)


def run(deed: Any) -> None:
    asyncio.run(in_time(deed, 3 * PATIENCE))
