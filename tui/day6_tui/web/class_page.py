"""The teacher's page: `class` and its WebSocket `class/ws`, for the teacher's token only.

The server says {"t":"rows"} after a change, at most twice a second; the page says {"t":"order","name","order"}, where the name
`*`, which nobody can have, is everybody. To what is more than looking the server answers {"t":"sent","do","count","missed"}.
As long as a page is open, a teacher is there (`Roster.attend`); a reload takes less than GRACE.

class/log.csv is what happened in the lesson, as a table.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from dataclasses import asdict
from datetime import date
from pathlib import Path
from typing import Any

from aiohttp import WSCloseCode, WSMsgType, web

from day6_core.classroom import order as orders
from day6_core.classroom.order import OrderError
from day6_core.classroom.roster import PupilRow
from day6_core.lessons.scene import scenes
from day6_tui.classes import log as class_log
from day6_tui.locale import Texts
from day6_tui.web import pages
from day6_tui.web.gate import Gate
from day6_tui.web.roster_feed import RosterFeed
from day6_tui.web.tokens import TEACHER

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
ALL = "*"


def _scenes() -> list[dict[str, Any]]:
    """What a teacher can start besides lessons."""
    return [
        {"name": name, "title": {language: texts.short for language, texts in scene.texts.items()}}
        for name, scene in scenes().items()
    ]


class ClassPage:
    """Shows the roster and takes orders. `state_of` tells of a pupil who is or was here: here, away (no tab), full, gone."""

    def __init__(
        self,
        gate: Gate,
        texts: Callable[[web.Request], Texts],
        feed: RosterFeed,
        state_of: Callable[[PupilRow], str],
        lessons: list[dict[str, Any]],
    ) -> None:
        self._gate = gate
        self._texts = texts
        self._feed = feed
        self._state_of = state_of
        self._lessons = lessons
        self._pages = 0
        self._leaving: asyncio.TimerHandle | None = None

    def routes(self) -> list[web.RouteDef]:
        """The addresses of the page."""
        return [
            web.get("/class", self._page),
            web.get("/class/ws", self._socket),
            web.get("/class/log.csv", self._log),
        ]

    async def _page(self, request: web.Request) -> web.StreamResponse:
        if self._gate.ticket(request, TEACHER) is None:
            return pages.message(self._texts(request), "serve.wrong.stranger", status=403)
        return web.FileResponse(STATIC / "class.html")

    async def _log(self, request: web.Request) -> web.StreamResponse:
        texts = self._texts(request)
        if self._gate.ticket(request, TEACHER) is None:
            return pages.message(texts, "serve.wrong.stranger", status=403, up="../")
        body = class_log.as_csv(self._feed.roster.events, texts)
        name = f"class-log-{date.today():%Y-%m-%d}.csv"
        return web.Response(
            body=body, content_type="text/csv", headers={"Content-Disposition": f'attachment; filename="{name}"'}
        )

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
            self._leaving = asyncio.get_running_loop().call_later(GRACE, self._feed.roster.attend, False)

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        if not self._gate.is_from_here(request) or self._gate.ticket(request, TEACHER) is None:
            return web.Response(status=403, text="No token.\n")
        ws = web.WebSocketResponse(max_msg_size=LONGEST_FRAME, heartbeat=BEAT, timeout=2.0)
        await ws.prepare(request)
        language = self._texts(request).language
        await ws.send_json({"t": "hello", "lang": language, "lessons": self._lessons, "scenes": _scenes()})
        changed = asyncio.Event()
        changed.set()
        end = self._feed.subscribe(changed.set)
        self._came()
        showing = asyncio.create_task(self._show(ws, changed, self._texts(request)))
        try:
            reason = await self._listen(ws)
        finally:
            end()
            self._went()
            showing.cancel()
            await asyncio.gather(showing, return_exceptions=True)
        await ws.close(code=WSCloseCode.POLICY_VIOLATION if reason else WSCloseCode.OK, message=reason.encode())
        return ws

    async def _show(self, ws: web.WebSocketResponse, changed: asyncio.Event, texts: Texts) -> None:
        """Send the rows after every change; a slow teacher gets fewer."""
        while True:
            changed.clear()
            now = self._feed.roster.now
            rows = [self._told(row, now, texts) for row in self._feed.roster.rows()]
            await ws.send_json({"t": "rows", "rows": rows, "frozen": self._feed.roster.is_frozen})
            await asyncio.sleep(PAUSE)
            try:
                await asyncio.wait_for(changed.wait(), TICK)
            except asyncio.TimeoutError:
                continue

    def _told(self, row: PupilRow, now: float, texts: Texts) -> dict[str, Any]:
        note = {} if row.note is None else asdict(row.note)
        if row.note is not None:
            note["refused"] = texts(row.note.refused) if row.note.refused else ""
        return {
            **note,
            "name": row.name,
            "state": self._state_of(row),
            "idle": row.idle(now),
            "stuck": row.is_stuck(now),
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
        if found["t"] == "ping":
            await ws.send_json({"t": "pong", "n": int(found["n"])})
        elif found["t"] == "order":
            roster, name = self._feed.roster, str(found["name"])
            try:
                order = orders.of(found["order"])
            except OrderError as error:
                raise ValueError(str(error)) from None
            names = roster.everybody() if name == ALL else [name]
            if order.do == "freeze":
                missed = roster.freeze(order.on, None if name == ALL else name)
                self._feed.tell()
            else:
                missed = roster.order(names, order)
            if order.do not in SILENT:
                count = len(names) - len(missed)
                await ws.send_json({"t": "sent", "do": order.do, "count": count, "missed": missed})
