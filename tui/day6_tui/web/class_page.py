"""The teacher's page: `class` and its WebSocket `class/ws`, for the teacher's token only.

The server says {"t":"rows"} after a change, at most twice a second; the page says {"t":"order","names","order"}, where the names
`*` are everybody. To what is more than looking the server answers {"t":"sent","do","count","missed"}. What else the page can
say, what the rows come with and what other addresses there are is each a `ClassPart`.
As long as a page is open, a teacher is there (`Roster.attend`); a reload takes less than GRACE.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from aiohttp import WSCloseCode, WSMsgType, web

from day6_core.classroom import order as orders
from day6_core.classroom.order import OrderError
from day6_core.classroom.roster import PupilRow
from day6_core.lessons.scene import scenes
from day6_tui.locale import Texts
from day6_tui.web import connections, pages
from day6_tui.web.class_admin import ClassAdmin
from day6_tui.web.class_answers import ClassAnswers
from day6_tui.web.class_assignments import ClassAssignments
from day6_tui.web.class_door import ClassDoor
from day6_tui.web.class_groups import ClassGroups
from day6_tui.web.class_handed import ClassHanded
from day6_tui.web.class_machine import ClassMachine
from day6_tui.web.class_part import Answer, ClassPart, Hear, names_of
from day6_tui.web.class_show import ClassShow
from day6_tui.web.entrance import Entrance
from day6_tui.web.gate import Gate
from day6_tui.web.in_time import in_time, stop
from day6_tui.web.sessions import Sessions
from day6_tui.web.tokens import TEACHER
from day6_tui.web.told import told

STATIC = Path(__file__).parent / "static"

PAUSE = 0.5
"""Seconds between two messages at least."""
TICK = 10.0
"""And at most: how long somebody has been idle grows without a note."""

GRACE = 10.0
"""Seconds without a page after which the teacher counts as gone."""

LONGEST_FRAME = 16 << 10
BEAT = 20.0
SILENT = ("watch", "unwatch", "tell", "type")
"""Orders whose way is not told: they come again and again."""


def _scenes() -> list[dict[str, Any]]:
    """What a teacher can start besides lessons."""
    return [
        {"name": name, "title": {language: texts.short for language, texts in scene.texts.items()}}
        for name, scene in scenes().items()
    ]


class ClassPage:
    """Shows the roster and what its parts add to it, and takes orders."""

    def __init__(
        self,
        gate: Gate,
        texts: Callable[[web.Request], Texts],
        sessions: Sessions,
        entrance: Entrance,
        lessons: list[dict[str, Any]],
        *,
        has_word: bool,
    ) -> None:
        self._gate = gate
        self._texts = texts
        self._sessions = sessions
        self._feed = sessions.feed
        self._entrance = entrance
        self._lessons = lessons
        self._has_word = has_word
        self._background = sessions.background
        self._pages = 0
        self._leaving: asyncio.TimerHandle | None = None
        self._assignments = ClassAssignments(gate, sessions, texts)
        self._parts: list[ClassPart] = [
            ClassDoor(entrance, sessions),
            ClassShow(gate, texts, sessions),
            ClassGroups(sessions.feed, sessions.folder / "groups.json"),
            ClassAnswers(sessions.feed),
            ClassHanded(gate, sessions),
            self._assignments,
            ClassAdmin(sessions),
            ClassMachine(sessions),
        ]
        self._hears: dict[str, Hear] = {"ping": self._ping, "order": self._order}
        for part in self._parts:
            self._hears |= part.hears()

    async def begin(self, _app: web.Application) -> None:
        """The server begins."""
        await self._assignments.begin()

    def routes(self) -> list[web.RouteDef]:
        """The addresses of the page."""
        return [
            web.get("/class", self._page),
            web.get("/class/ws", self._socket),
            *(route for part in self._parts for route in part.routes()),
        ]

    async def _page(self, request: web.Request) -> web.StreamResponse:
        if self._gate.ticket(request, TEACHER) is None:
            return pages.message(self._texts(request), "serve.wrong.stranger", status=403)
        return web.FileResponse(STATIC / "class.html")

    def _came(self) -> None:
        """One more page is open."""
        self._pages += 1
        if self._leaving is not None:
            self._leaving.cancel()
            self._leaving = None
        self._feed.roster.attend(True)

    def _went(self) -> None:
        """One is closed."""
        self._pages -= 1
        if not self._pages:
            self._leaving = asyncio.get_running_loop().call_later(GRACE, self._leave)

    def _leave(self) -> None:
        self._feed.roster.attend(False)
        self._feed.tell()

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        if not self._gate.is_from_here(request) or self._gate.ticket(request, TEACHER) is None:
            return web.Response(status=403, text="No token.\n")
        ws = web.WebSocketResponse(max_msg_size=LONGEST_FRAME, heartbeat=BEAT, timeout=2.0)
        await ws.prepare(request)
        connections.keep(request)
        language = self._texts(request).language
        hello = {"t": "hello", "lang": language, "lessons": self._lessons, "scenes": _scenes(), "word": self._has_word}
        hello["days"] = [day.isoformat() for day in self._feed.roster.journal.days()]
        await ws.send_json(hello)
        changed = asyncio.Event()
        changed.set()
        end = self._feed.subscribe(changed.set)
        self._came()
        showing = self._background.begin("serve.failed.page", self._show(ws, changed, self._texts(request)))
        listening = asyncio.create_task(self._listen(ws))
        try:
            await asyncio.wait({showing, listening}, return_when=asyncio.FIRST_COMPLETED)
            reason = (
                listening.result() if listening.done() else ""
            )  # a page that is shown nothing new has to come again
        finally:
            end()
            self._went()
            await stop(showing, listening)
        await ws.close(code=WSCloseCode.POLICY_VIOLATION if reason else WSCloseCode.OK, message=reason.encode())
        return ws

    async def _show(self, ws: web.WebSocketResponse, changed: asyncio.Event, texts: Texts) -> None:
        """Send the rows after every change; a slow teacher gets fewer."""
        heard = self._feed.told
        while not ws.closed:
            changed.clear()
            now = self._feed.roster.now
            places = {name: place for place, name in enumerate(self._feed.roster.names())}
            rows = [{**self._told(row, now, texts), "place": places[row.name]} for row in self._feed.roster.rows()]
            news = [each for each in self._feed.news if each.number > heard]
            heard = self._feed.told
            state = {
                "frozen": self._feed.roster.is_frozen,
                "news": [told(texts, each.key, each.values) for each in news],
            }
            for part in self._parts:
                state |= part.state(texts)
            with contextlib.suppress(ConnectionError):
                await ws.send_json({"t": "rows", "rows": rows, **state})
            await asyncio.sleep(PAUSE)
            try:
                await in_time(changed.wait(), TICK)
            except asyncio.TimeoutError:
                continue

    def _told(self, row: PupilRow, now: float, texts: Texts) -> dict[str, Any]:
        note = {} if row.note is None else asdict(row.note)
        if row.note is not None:
            note["refused"] = texts(row.note.refused) if row.note.refused else ""
        return {
            **note,
            "name": row.name,
            "state": self._sessions.state_of(row),
            "address": self._sessions.address_of(row.name),
            "listed": self._entrance.is_listed(row.name),
            "idle": row.idle(now),
            "stuck": row.is_stuck(now),
            "raised": None if row.raised is None else now - row.raised,
            "on_step": None if row.arrived is None else now - row.arrived,
        }

    async def _listen(self, ws: web.WebSocketResponse) -> str:
        """Take orders until the page goes; returns why it has to, if it has."""
        async for message in ws:
            if message.type != WSMsgType.TEXT:
                return "text is expected"
            try:
                await self._obey(ws, json.loads(message.data))
            except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
                return f"nonsense: {type(error).__name__}"
        return ""

    async def _obey(self, ws: web.WebSocketResponse, found: dict[str, Any]) -> None:
        if (answer := await self._hears[found["t"]](found)) is not None:
            await ws.send_json(answer)

    async def _ping(self, found: dict[str, Any]) -> Answer:
        return {"t": "pong", "n": int(found["n"])}

    async def _order(self, found: dict[str, Any]) -> Answer:
        roster, names = self._feed.roster, names_of(found)
        try:
            order = orders.of(found["order"])
        except OrderError as error:
            raise ValueError(str(error)) from None
        chosen = roster.everybody() if names is None else names
        if order.do == "freeze":
            missed = roster.freeze(order.on, names)
            self._feed.tell()
        elif order.do == "link":
            missed = roster.hand(chosen, replace(order, number=0))
            self._feed.tell()
        else:
            missed = roster.order(chosen, order)
        if order.do in SILENT:
            return None
        return {"t": "sent", "do": order.do, "count": len(chosen) - len(missed), "missed": missed}
