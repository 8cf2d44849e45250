"""The teacher's page: `class` and its WebSocket `class/ws`, for the teacher's token only."""

from __future__ import annotations

from collections.abc import Callable

from aiohttp import web

from day6_tui.tui.locale import Texts
from day6_tui.tui.web import pages
from day6_tui.tui.web.gate import Gate
from day6_tui.tui.web.tokens import TEACHER


def routes(gate: Gate, texts: Callable[[web.Request], Texts]) -> list[web.RouteDef]:
    """The addresses of the teacher's page."""

    async def page(request: web.Request) -> web.StreamResponse:
        if gate.ticket(request, TEACHER) is None:
            return pages.message(texts(request), "serve.wrong.stranger", status=403)
        raise web.HTTPSeeOther("links")

    return [web.get("/class", page)]
