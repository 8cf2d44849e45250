"""One screen shown to the class, live: the teacher's own desktop, or a pupil's who has said yes.

The teacher's page says {"t":"show","do","name","names","full"}: `do` is start, again (`full` or not) or stop, `name` the pupil's
or "" for the teacher's own desktop (`/mine`, a desktop like a pupil's), `names` to whom. What is shown is what a desktop says of
its screen in its notes, which is text and colours and nothing else: no byte of a pupil's desktop reaches another's browser.

Each tab of those whom it is for hears {"t":"show","on","name","full"} on its own line, and takes the pictures from another one,
`shown`: after {"t":"hello"} come {"t":"screen"} (`Picture`), the next when the page says {"t":"ack"} that it has drawn the
last. So the desktop that is shown waits for nobody, and who is slow sees fewer pictures, not older ones.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from aiohttp import WSMsgType, web

from day6_core.classroom.homes import same_name
from day6_core.classroom.note import Note, PupilScreen
from day6_core.classroom.order import Order
from day6_core.classroom.show import OWN, Show, Stage
from day6_tui.locale import Texts
from day6_tui.web import connections, pages
from day6_tui.web.class_part import Answer, Hear, names_of
from day6_tui.web.gate import Gate
from day6_tui.web.in_time import stop
from day6_tui.web.names import TEACHERS
from day6_tui.web.picture import Picture
from day6_tui.web.sessions import Sessions
from day6_tui.web.tokens import PUPIL, TEACHER
from day6_tui.web.viewer import Viewer

STATIC = Path(__file__).parent / "static"

LEAST_PAUSE = 0.1
"""Seconds between two pictures for one page."""
BYTES_A_SECOND = 256 << 10
"""For one page at most, on average: a hostile desktop can send pictures of any size."""

LONGEST_FRAME = 1024
BEAT = 20.0


def _source(desktop: str) -> str:
    """The name under which a desktop is shown."""
    return OWN if desktop == TEACHERS else desktop


def _told(show: Show) -> dict[str, Any]:
    """What a page says of it."""
    return {"name": show.source, "full": show.full}


class ClassShow:
    """Carries what is shown to the tabs: the projector of the stage. Everything in the event loop."""

    def __init__(self, gate: Gate, texts: Callable[[web.Request], Texts], sessions: Sessions) -> None:
        self._gate = gate
        self._texts = texts
        self._sessions = sessions
        self._feed = sessions.feed
        self._stage = Stage(sessions.feed.roster, self, lambda *what: asyncio.get_running_loop().call_later(*what))
        self._picture, self._drawn = Picture(), ""
        """What the pages draw, and of whose screen."""
        self._wakes: set[asyncio.Event] = set()
        """Of the pages that look."""
        sessions.came = self._came
        self._feed.noted = self._noted
        self._feed.subscribe(self._stage.look_for_teacher)

    def hears(self) -> dict[str, Hear]:
        """What the teacher wants to be shown."""
        return {"show": self._obey}

    def state(self, texts: Texts) -> dict[str, Any]:
        """What is shown and what is wanted (None, or as a pupil's page hears it), to how many (None: all); is my desktop open?"""
        shows = {"on": self._stage.on, "wanted": self._stage.wanted}
        found: dict[str, Any] = {
            key: each and {**_told(each), "count": None if each.names is None else len(each.names)}
            for key, each in shows.items()
        }
        return {"show": found | {"mine": any(name == TEACHERS for name, _ in self._sessions.typing_tabs())}}

    def routes(self) -> list[web.RouteDef]:
        """The teacher's desktop, and the pictures for all others."""
        return [web.get("/mine", self._mine), web.get("/shown", self._socket)]

    async def _mine(self, request: web.Request) -> web.StreamResponse:
        if self._gate.ticket(request, TEACHER) is None:
            return pages.message(self._texts(request), "serve.wrong.stranger", status=403)
        return web.FileResponse(STATIC / "desk.html")

    # -- what the teacher wants ----------------------------------------------------------------------------------------

    async def _obey(self, found: dict[str, Any]) -> Answer:
        if found["do"] == "stop":
            self._stage.stop()
        elif found["do"] == "start":
            names = names_of(found)
            keys = None if names is None else frozenset(map(same_name, names))
            self._stage.start(Show(str(found["name"]), keys, found["full"] is True))
        elif found["do"] == "again":
            self._stage.again(full=found["full"] is True)
        else:
            raise ValueError("there is no such show")
        return None

    # -- for the stage -------------------------------------------------------------------------------------------------

    def send(self, name: str, order: Order) -> bool:
        return self._feed.send(TEACHERS if name == OWN else name, order)

    def say(self, key: str, name: str) -> None:
        self._feed.say(f"class.show.{key}", name=name)

    def changed(self) -> None:
        """Tell all tabs, and the lines of those who look."""
        show = self._stage.on
        if show is None or show.source != self._drawn:
            self._picture = Picture()
        self._drawn = "" if show is None else show.source
        for name, viewer in self._sessions.typing_tabs():
            self._tell(name, viewer)
        self._wake()
        self._feed.tell()

    def project(self, screen: PupilScreen) -> None:
        if self._picture.take(screen):
            self._wake()

    def _noted(self, name: str, note: Note | None) -> None:
        self._stage.noted(_source(name), note)

    def _wake(self) -> None:
        for wakes in self._wakes:
            wakes.set()

    # -- the tabs ------------------------------------------------------------------------------------------------------

    def _came(self, name: str, viewer: Viewer) -> None:
        """A tab has come, perhaps again, and thinks that something is shown which is no longer."""
        self._tell(name, viewer)

    def _tell(self, name: str, viewer: Viewer) -> None:
        show, source, wanted = self._stage.on, _source(name), self._stage.wanted
        if show is not None and not show.is_for(source):
            show = None
        told = _told(show) if show is not None else {}
        if wanted is not None and source == wanted.source:
            told["full"] = False  # the question is on the desktop below
        said = viewer.say(t="show", on=show is not None, **told)
        self._sessions.background.begin("serve.failed.page", said)

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        """`?mine=1` is the teacher's desktop."""
        ticket = self._gate.ticket(request, TEACHER if "mine" in request.query else PUPIL)
        if not self._gate.is_from_here(request) or ticket is None:
            return web.Response(status=403, text="No token.\n")
        name = ticket.name if ticket.kind == PUPIL else OWN

        def is_for() -> bool:
            """Whether it still is: what is shown may change, and who may come in."""
            show = self._stage.on
            return show is not None and show.is_for(name) and self._gate.ticket(request, ticket.kind) == ticket

        if not is_for():
            return web.Response(status=403, text="Nothing is shown to you.\n")
        ws = web.WebSocketResponse(max_msg_size=LONGEST_FRAME, heartbeat=BEAT, timeout=2.0)
        await ws.prepare(request)
        connections.keep(request)
        page = _Page(ws)
        self._wakes.add(page.wakes)
        sending = asyncio.create_task(self._send(page, is_for))
        listening = asyncio.create_task(page.listen())
        try:
            await asyncio.wait({sending, listening}, return_when=asyncio.FIRST_COMPLETED)
        finally:
            self._wakes.discard(page.wakes)
            await stop(sending, listening)
        await ws.close()
        return ws

    async def _send(self, page: _Page, is_for: Callable[[], bool]) -> None:
        """Send what has changed, whenever the page has drawn the last of it."""
        with contextlib.suppress(ConnectionError):
            await page.ws.send_json({"t": "hello"})
            picture, seen = self._picture, 0
            while is_for():
                if picture is not self._picture:
                    picture, seen = self._picture, 0
                page.wakes.clear()
                if seen < picture.version and page.has_drawn:
                    said, seen = picture.since(seen), picture.version
                    page.has_drawn = False
                    await page.ws.send_str(said)
                    await asyncio.sleep(max(LEAST_PAUSE, len(said) / BYTES_A_SECOND))
                else:
                    await page.wakes.wait()
            await page.ws.send_json({"t": "bye", "why": "ended"})


class _Page:
    """The line of one page that looks."""

    def __init__(self, ws: web.WebSocketResponse) -> None:
        self.ws = ws
        self.wakes = asyncio.Event()
        self.has_drawn = True
        """Whether it has drawn what was sent last."""

    async def listen(self) -> None:
        """Take what the page says until it goes, or says what no page of ours does."""
        async for message in self.ws:
            try:
                found = json.loads(message.data) if message.type == WSMsgType.TEXT else {}
                if found["t"] == "ping":
                    await self.ws.send_json({"t": "pong", "n": int(found["n"])})
                elif found["t"] == "ack":
                    self.has_drawn = True
                    self.wakes.set()
            except (ValueError, TypeError, KeyError, RecursionError):
                return
