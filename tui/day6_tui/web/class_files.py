"""What the teacher saves of a class, as tables for a spreadsheet, for the teacher's token only.

class/log.csv is what happened today, or with ?day=YYYY-MM-DD on that day; class/report.csv is how far every pupil is, over all
days: what `day6-tui report --data` writes.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from datetime import date

from aiohttp import web

from day6_core.classroom.journal import Journal
from day6_core.lessons.catalogue import offer
from day6_core.lessons.class_table import class_of, table_of
from day6_core.lessons.tables import csv_bytes
from day6_core.reason import named_reason
from day6_tui.classes import log
from day6_tui.locale import Texts
from day6_tui.web import pages
from day6_tui.web.gate import Gate
from day6_tui.web.settings import ServerSettings
from day6_tui.web.tokens import TEACHER


class ClassFiles:
    """Makes the tables, in threads."""

    def __init__(
        self, gate: Gate, texts: Callable[[web.Request], Texts], journal: Journal, settings: ServerSettings
    ) -> None:
        self._gate = gate
        self._texts = texts
        self._journal = journal
        self._settings = settings

    def routes(self) -> list[web.RouteDef]:
        """The addresses of the tables."""
        return [web.get("/class/log.csv", self._log), web.get("/class/report.csv", self._report)]

    async def _log(self, request: web.Request) -> web.StreamResponse:
        try:
            day = date.fromisoformat(request.query.get("day") or date.today().isoformat())
        except ValueError:
            return web.Response(status=400, text="day=YYYY-MM-DD\n")
        return await self._table(request, f"class-log-{day:%Y-%m-%d}.csv", lambda texts: self._logged(day, texts))

    async def _report(self, request: web.Request) -> web.StreamResponse:
        return await self._table(request, f"class-report-{date.today():%Y-%m-%d}.csv", self._reported)

    async def _table(self, request: web.Request, name: str, made: Callable[[Texts], bytes]) -> web.StreamResponse:
        texts = self._texts(request)
        if self._gate.ticket(request, TEACHER) is None:
            return pages.message(texts, "serve.wrong.stranger", status=403, up="../")
        try:
            body = await asyncio.to_thread(made, texts)
        except OSError as error:
            return web.Response(status=500, text=f"{named_reason(error)}\n")
        disposition = {"Content-Disposition": f'attachment; filename="{name}"'}
        return web.Response(body=body, content_type="text/csv", headers=disposition)

    def _logged(self, day: date, texts: Texts) -> bytes:
        return log.as_csv(self._journal.events(day), texts)

    def _reported(self, texts: Texts) -> bytes:
        table = table_of(class_of(self._settings.data), offer(self._settings.lessons), texts.language)
        return csv_bytes(table.heads, table.rows)
