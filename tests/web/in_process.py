"""A server in this process, without desktops, and the class page without a page."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from day6_core.isolation.modes import ModeOffer
from day6_core.isolation.same_user import Nothing
from day6_tui.detached import meeting
from day6_tui.web import class_page, connections, server, sessions
from day6_tui.web.settings import ServerSettings
from tests.support.waiting import Deadline
from tests.web.in_time import in_time
from tests.web.serving import WORD, Browser, browser, run


@dataclass
class InProcess:
    """A server in this process, and what its user was told."""

    base: str = ""
    server: Any = None
    said: list[str] = field(default_factory=list)
    values: list[dict[str, Any]] = field(default_factory=list)

    def tell(self, key: str, **values: object) -> None:
        self.said.append(key)
        self.values.append(values)
        if key == "serve.at":
            self.base = str(values["address"])
        elif key == "serve.teacher":
            self.teacher = str(values["link"])

    @property
    def sessions(self) -> sessions.Sessions:
        found: sessions.Sessions = self.server._sessions
        return found


@asynccontextmanager
async def serving(folder: Path, **settings: Any) -> AsyncIterator[InProcess]:
    made = InProcess()
    offer = ModeOffer("none", Nothing())
    chosen: dict[str, Any] = {"data": folder / "class", "port": 0, "word": WORD} | settings
    made.server = server.Server(ServerSettings(**chosen), offer, made.tell)
    await made.server.open()
    try:
        yield made
    finally:
        await made.server.close()


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(tmp_path / "run"))
    monkeypatch.setattr(class_page, "PAUSE", 0.01)
    monkeypatch.setattr(connections, "HEADER_SECONDS", 600.0)  # however slow the machine is
    monkeypatch.setattr(connections, "BODY_SECONDS", 600.0)
    monkeypatch.setattr(meeting, "connect", lambda *_: None)  # no desktop runs


def deed_of(folder: Path, deed: Callable[[InProcess, Browser], Coroutine[Any, Any, None]], **settings: Any) -> None:
    async def whole() -> None:
        async with serving(folder, **settings) as made, browser(made.base) as door:
            await deed(made, door)

    run(whole())


class Teacher:
    """The class page without a page."""

    def __init__(self, ws: Any) -> None:
        self._ws = ws
        self.rows: dict[str, Any] = {}

    async def order(self, do: str, **more: object) -> None:
        await self._ws.send_json({"t": "door", "do": do, **more})

    async def until(self, wanted: Callable[[dict[str, Any]], object]) -> dict[str, Any]:
        """The first state of which this is true."""
        deadline = Deadline()
        while not (self.rows and wanted(self.rows)):
            assert not deadline.is_over(), self.rows
            message = await in_time(self._ws.receive_json())
            if message["t"] == "rows":
                self.rows = message
        return self.rows


@asynccontextmanager
async def teaching(made: InProcess) -> AsyncIterator[Teacher]:
    async with browser(made.base) as door:
        await door.get(made.teacher)
        ws = await door.session.ws_connect(f"{door.base}class/ws", headers=door.origin)
        assert (await ws.receive_json())["word"] is True
        yield Teacher(ws)
        await ws.close()
