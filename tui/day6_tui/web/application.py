"""The addresses of the server and what answers there."""

from __future__ import annotations

import hmac
from pathlib import Path
from typing import Any

from aiohttp import web

from day6_core.isolation.cell import IsolationError, Phrase
from day6_tui.locale import Texts
from day6_tui.web import link_page, pages, socket
from day6_tui.web.class_page import ClassPage
from day6_tui.web.gate import Gate
from day6_tui.web.links import Links
from day6_tui.web.names import BadName, clean
from day6_tui.web.sessions import Sessions, Tell
from day6_tui.web.settings import ServerSettings
from day6_tui.web.tokens import PUPIL, TEACHER, WATCHER, Ticket, Tokens

STATIC = Path(__file__).parent / "static"

_LARGEST_FORM = 4096


class Application:
    """Answers the browsers."""

    def __init__(
        self,
        settings: ServerSettings,
        tokens: Tokens,
        links: Links,
        sessions: Sessions,
        what_it_is: Phrase,
        tell: Tell,
        lessons: list[dict[str, Any]],
    ) -> None:
        self._settings = settings
        self._tokens = tokens
        self._links = links
        self._sessions = sessions
        self._what_it_is = what_it_is
        self._tell = tell
        self._gate = Gate(settings, tokens)
        self._class = ClassPage(self._gate, self._texts, sessions.feed, sessions.state_of, lessons)

    def build(self) -> web.Application:
        """The application that aiohttp serves."""
        app = web.Application(middlewares=[self._gate.guard], client_max_size=_LARGEST_FORM)
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
                web.static("/static", STATIC),
                *link_page.routes(self._gate, self._links, self._texts),
                *self._class.routes(),
            ]
        )
        return app

    def _texts(self, request: web.Request) -> Texts:
        return Texts(pages.language_for(request, self._settings.lang))

    # -- the way in ----------------------------------------------------------------------------------------------------

    async def _start(self, request: web.Request) -> web.StreamResponse:
        if self._settings.proxied:  # there is nothing to choose
            return web.Response(status=303, headers={"Location": "desk"})
        ticket = self._gate.ticket(request, PUPIL)
        return self._first_page(request, name=None if ticket is None else ticket.name)

    def _first_page(
        self, request: web.Request, *, name: str | None = None, typed: str = "", wrong: str = "", status: int = 200
    ) -> web.Response:
        texts = self._texts(request)
        asks = self._settings.word is not None
        return pages.start(
            texts, apart=self._apart(texts), asks_word=asks, name=name, typed=typed, wrong=wrong, status=status
        )

    def _apart(self, texts: Texts) -> str:
        """How pupils are kept apart, said to a pupil."""
        if self._what_it_is.key == "isolation.is.none":
            return texts("serve.start.none")
        return f"{texts('serve.start.apart')} {texts(self._what_it_is.key, **self._what_it_is.values)}"

    async def _enter(self, request: web.Request) -> web.StreamResponse:
        """The class word and a name."""
        texts, address = self._texts(request), self._gate.address(request)
        if self._gate.tries.are_too_many(address):
            return self._first_page(request, wrong=texts("serve.wrong.often"), status=429)
        form = await self._gate.form(request)
        word, right, typed = form.get("word", "").strip(), self._settings.word, form.get("name", "")
        if right is None or not hmac.compare_digest(word.encode(errors="replace"), right.encode(errors="replace")):
            self._gate.tries.add(address)
            return self._first_page(request, typed=typed, wrong=texts("serve.wrong.word"), status=403)
        try:
            ticket = Ticket(PUPIL, clean(typed))
        except BadName as error:
            return self._first_page(request, typed=typed, wrong=texts(str(error)), status=400)
        if self._tokens.has(ticket):
            wrong = texts("serve.wrong.name", name=ticket.name)
            return self._first_page(request, typed=typed, wrong=wrong, status=409)
        token = self._tokens.make(ticket)
        try:
            await self._links.keep()
        except OSError as error:
            self._tokens.revoke(ticket)
            self._tell("serve.no_record", file=str(error.filename), reason=error.strerror or str(error))
            return self._first_page(request, wrong=texts("serve.wrong.disk"), status=507)
        response = web.Response(status=303, headers={"Location": "desk"})
        self._gate.let_in(response, PUPIL, token)
        return response

    async def _leave(self, request: web.Request) -> web.StreamResponse:
        response = web.Response(status=303, headers={"Location": "./"})
        self._gate.forget(response, PUPIL)
        return response

    async def _link(self, request: web.Request) -> web.StreamResponse:
        """A link with a token. A right one is never refused: its 128 bits are not found by trying."""
        token = request.match_info["token"]
        ticket = self._tokens.of(token)
        if ticket is None:
            address = self._gate.address(request)
            often = self._gate.tries.are_too_many(address)
            self._gate.tries.add(address)
            key, status = ("serve.wrong.often", 429) if often else ("serve.wrong.link", 403)
            return pages.message(self._texts(request), key, status=status, up="../")
        to = {PUPIL: "../desk", WATCHER: "../watch", TEACHER: "../class"}[ticket.kind]
        response = pages.entering(self._texts(request), to)
        self._gate.let_in(response, ticket.kind, token)
        return response

    # -- the desktop ---------------------------------------------------------------------------------------------------

    async def _desk(self, request: web.Request) -> web.StreamResponse:
        return self._page(request, PUPIL)

    async def _watch(self, request: web.Request) -> web.StreamResponse:
        return self._page(request, WATCHER)

    def _page(self, request: web.Request, kind: str) -> web.StreamResponse:
        if self._gate.ticket(request, kind) is None:
            return pages.message(self._texts(request), "serve.wrong.stranger", status=403)
        return web.FileResponse(STATIC / "desk.html")

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        """`?watch=1` is the page of who only watches, whatever other cookies the browser has."""
        if not self._gate.is_from_here(request):
            return web.Response(status=403, text="This page does not come from this server.\n")
        kinds = (WATCHER,) if "watch" in request.query else (PUPIL, WATCHER)
        ticket = next((found for kind in kinds if (found := self._gate.ticket(request, kind)) is not None), None)
        if ticket is None:
            return web.Response(status=403, text="No token.\n")
        lang = pages.language_for(request, self._settings.lang)
        return await socket.talk(request, self._sessions, ticket, lang=lang, refused=self._refused)

    def _refused(self, name: str, error: Exception) -> None:
        reason = str(error)
        if isinstance(error, IsolationError):
            reason = Texts(self._settings.lang)(error.words.key, **error.words.values)
        self._tell("serve.refused", name=name, reason=reason)
