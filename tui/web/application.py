"""The addresses of the server and what answers there."""

from __future__ import annotations

import hmac
from pathlib import Path

from aiohttp import web

from day6_tui.core.isolation.cell import Words
from day6_tui.tui.locale import Texts
from day6_tui.tui.web import pages, socket
from day6_tui.tui.web.gate import Gate
from day6_tui.tui.web.names import BadName, clean
from day6_tui.tui.web.sessions import Sessions
from day6_tui.tui.web.settings import Settings
from day6_tui.tui.web.tokens import PUPIL, TEACHER, WATCHER, Ticket, Tokens

STATIC = Path(__file__).parent / "static"

_LONGEST_FORM = 4096


class Application:
    """Answers the browsers."""

    def __init__(self, settings: Settings, tokens: Tokens, sessions: Sessions, what_it_is: Words) -> None:
        self._settings = settings
        self._tokens = tokens
        self._sessions = sessions
        self._what_it_is = what_it_is
        self._gate = Gate(settings, tokens)

    def build(self) -> web.Application:
        """The application that aiohttp serves."""
        app = web.Application(middlewares=[self._gate.guard], client_max_size=_LONGEST_FORM)
        app.on_response_prepare.append(self._gate.sign)
        app.add_routes(
            [
                web.get("/", self._start),
                web.post("/enter", self._enter),
                web.post("/leave", self._leave),
                web.get("/p/{token}", self._link),
                web.get("/desk", self._desk),
                web.get("/watch", self._watch),
                web.get("/ws", self._socket),
                web.get("/watch/ws", self._socket),
                web.static("/static", STATIC),
            ]
        )
        return app

    def _texts(self, request: web.Request) -> Texts:
        return Texts(pages.language_for(request, self._settings.lang))

    async def _start(self, request: web.Request) -> web.StreamResponse:
        ticket = self._gate.ticket(request)
        return self._first_page(request, name=ticket.name if ticket is not None and ticket.kind == PUPIL else None)

    def _first_page(
        self, request: web.Request, *, name: str | None = None, wrong: str = "", status: int = 200
    ) -> web.Response:
        texts = self._texts(request)
        what = texts(self._what_it_is.key, **self._what_it_is.values)
        asks = self._settings.word is not None
        return pages.start(texts, what_it_is=what, asks_word=asks, name=name, wrong=wrong, status=status)

    async def _enter(self, request: web.Request) -> web.StreamResponse:
        """The class word and a name."""
        texts = self._texts(request)
        address = self._gate.address(request)
        if self._gate.tries.are_too_many(address):
            return self._first_page(request, wrong=texts("serve.wrong.often"), status=429)
        form = await request.post()
        word, name = str(form.get("word", "")), str(form.get("name", ""))
        right = self._settings.word
        if right is None or not hmac.compare_digest(word.strip().encode(), right.encode()):
            self._gate.tries.add(address)
            return self._first_page(request, wrong=texts("serve.wrong.word"), status=403)
        try:
            ticket = Ticket(PUPIL, clean(name))
        except BadName as error:
            return self._first_page(request, wrong=texts(str(error)), status=400)
        if self._tokens.has(ticket):
            return self._first_page(request, wrong=texts("serve.wrong.name", name=ticket.name), status=409)
        token = self._tokens.make(ticket)
        await self._save()
        response = web.Response(status=303, headers={"Location": "desk"})
        self._gate.let_in(response, token)
        return response

    async def _save(self) -> None:
        self._tokens.save()

    async def _leave(self, request: web.Request) -> web.StreamResponse:
        response = web.Response(status=303, headers={"Location": "./"})
        self._gate.forget(response)
        return response

    async def _link(self, request: web.Request) -> web.StreamResponse:
        """A link with a token."""
        texts = self._texts(request)
        token = request.match_info["token"]
        ticket = self._tokens.of(token)
        if ticket is None:
            address = self._gate.address(request)
            often = self._gate.tries.are_too_many(address)
            self._gate.tries.add(address)
            key, status = ("serve.wrong.often", 429) if often else ("serve.wrong.link", 403)
            return pages.message(texts, key, status=status, up="../")
        to = {PUPIL: "../desk", WATCHER: "../watch", TEACHER: "../class"}[ticket.kind]
        response = pages.entering(texts, to)
        self._gate.let_in(response, token)
        return response

    async def _desk(self, request: web.Request) -> web.StreamResponse:
        return self._page(request, PUPIL, "desk.html")

    async def _watch(self, request: web.Request) -> web.StreamResponse:
        return self._page(request, WATCHER, "desk.html")

    def _page(self, request: web.Request, kind: str, name: str) -> web.StreamResponse:
        ticket = self._gate.ticket(request)
        if ticket is None or ticket.kind != kind:
            return pages.message(self._texts(request), "serve.wrong.stranger", status=403)
        return web.FileResponse(STATIC / name)

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        if not self._gate.is_from_here(request):
            return web.Response(status=403, text="This page does not come from this server.\n")
        ticket = self._gate.ticket(request)
        if ticket is None or ticket.kind == TEACHER:
            return web.Response(status=403, text="No token.\n")
        read_only = ticket.kind == WATCHER
        lang = self._settings.lang
        return await socket.talk(request, self._sessions, ticket.name, read_only=read_only, lang=lang)
