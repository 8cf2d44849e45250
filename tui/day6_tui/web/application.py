"""The addresses of the server and what answers there."""

from __future__ import annotations

import hmac
import unicodedata
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from aiohttp import web

from day6_core.isolation.cell import IsolationError, Phrase
from day6_core.reason import named_reason
from day6_tui.locale import Texts
from day6_tui.web import link_page, pages, socket
from day6_tui.web.class_files import ClassFiles
from day6_tui.web.class_page import ClassPage
from day6_tui.web.entrance import Entrance, NotIn
from day6_tui.web.gate import Gate
from day6_tui.web.links import Links
from day6_tui.web.names import TEACHERS, who_is
from day6_tui.web.sessions import Sessions, Tell
from day6_tui.web.settings import ServerSettings
from day6_tui.web.tokens import PUPIL, TEACHER, WATCHER, Ticket, Tokens

STATIC = Path(__file__).parent / "static"

_LARGEST_FORM = 4096

LOBBY = "lobby"
"""The cookie of who waits."""


class Application:
    """Answers the browsers."""

    def __init__(
        self,
        settings: ServerSettings,
        tokens: Tokens,
        links: Links,
        sessions: Sessions,
        entrance: Entrance,
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
        self._entrance = entrance
        self._gate = Gate(settings, tokens)
        self._class = ClassPage(
            self._gate, self._texts, sessions, entrance, lessons, has_word=settings.word is not None
        )
        self._files = ClassFiles(self._gate, self._texts, sessions.feed.roster.journal, settings)

    def build(self) -> web.Application:
        """The application that aiohttp serves."""
        app = web.Application(middlewares=[self._gate.guard], client_max_size=_LARGEST_FORM)
        app.on_response_prepare.append(self._gate.sign)
        app.on_startup.append(self._class.begin)
        app.add_routes(
            [
                web.get("/", self._start),
                web.post("/enter", self._enter),
                web.get("/lobby", self._wait),
                web.post("/leave", self._leave),
                web.get("/manifest.webmanifest", self._manifest),
                web.get("/p/{token}", self._link),
                web.get("/come", self._come),
                web.get("/desk", self._desk),
                web.get("/watch", self._watch),
                web.get("/ws", self._socket),
                web.static("/static", STATIC),
                *link_page.routes(self._gate, self._links, self._sessions, self._texts),
                *self._class.routes(),
                *self._files.routes(),
            ]
        )
        return app

    def _texts(self, request: web.Request) -> Texts:
        return Texts(pages.language_for(request, self._settings.lang))

    # -- the way in ----------------------------------------------------------------------------------------------------

    async def _start(self, request: web.Request) -> web.StreamResponse:
        if self._settings.proxied:  # there is nothing to choose
            return _to("desk")
        if self._entrance.lobby.ask(self._gate.cookie(request, LOBBY)) is not None:
            return _to("lobby")
        return self._first_page(request)

    def _first_page(self, request: web.Request, *, typed: str = "", wrong: str = "", status: int = 200) -> web.Response:
        texts = self._texts(request)
        asks = self._settings.word is not None
        here = self._here(request)
        return pages.start(
            texts, apart=self._apart(texts), asks_word=asks, here=here, typed=typed, wrong=wrong, status=status
        )

    def _here(self, request: web.Request) -> list[str]:
        """The pupils who are signed in in this browser."""
        return [ticket.name for ticket in self._gate.tickets(request, PUPIL)]

    def _apart(self, texts: Texts) -> str:
        """How pupils are kept apart, said to a pupil."""
        if self._what_it_is.key == "isolation.is.none":
            return texts("serve.start.none")
        return f"{texts('serve.start.apart')} {texts(self._what_it_is.key, **self._what_it_is.values)}"

    async def _enter(self, request: web.Request) -> web.StreamResponse:
        """The class word and a name."""
        form = await self._gate.form(request)
        texts, address = self._texts(request), self._gate.address(request)
        word, right, typed = form.get("word", ""), self._settings.word, form.get("name", "")
        is_right = right is not None and hmac.compare_digest(_plain(word), _plain(right))
        if why := self._gate.tries.refusal(address, is_right=is_right):
            key, status = {"often": ("serve.wrong.often", 429), "wrong": ("serve.wrong.word", 403)}[why]
            return self._first_page(request, typed=typed, wrong=texts(key), status=status)
        try:
            found = await self._entrance.enter(typed, address, self._gate.cookie(request, LOBBY))
        except NotIn as no:
            wrong = texts(no.key, **no.values)
            return self._first_page(request, typed=typed, wrong=wrong, status=no.status)
        if found.waits:
            response = _to("lobby")
            self._gate.let_in(response, LOBBY, found.waits)
            return response
        return self._go(found.token, "desk" if "beside" in form else "come")

    def _go(self, token: str, page: str = "come") -> web.Response:
        """In with who got this token: to the desktop, or first to the question whether somebody else leaves."""
        ticket = self._tokens.of(token)
        if ticket is None:  # removed again in the meantime
            return _to("./")
        response = _to(page, ticket.name)
        self._gate.forget(response, LOBBY)
        self._gate.let_in(response, PUPIL, token, ticket.name)
        return response

    async def _come(self, request: web.Request) -> web.StreamResponse:
        """The browser has the cookie of who has just come; whoever was there before keeps theirs, unless it is said here."""
        newcomer = self._gate.ticket(request, PUPIL)
        if newcomer is None:
            return self._page(request, PUPIL)
        others = [name for name in self._here(request) if name != newcomer.name]
        if not others:
            return _to("desk", newcomer.name)
        return pages.beside(self._texts(request), newcomer.name, others)

    async def _wait(self, request: web.Request) -> web.StreamResponse:
        """The page of who waits for the teacher. Its script asks by HEAD, which changes nothing."""
        key = self._gate.cookie(request, LOBBY)
        newcomer = self._entrance.lobby.ask(key)
        is_pending = newcomer is not None and newcomer.is_pending
        if is_pending:
            self._sessions.feed.tell()
        if request.method == "HEAD":
            return web.Response(status=204 if is_pending else 200)
        if newcomer is not None and is_pending:
            return pages.lobby(self._texts(request), newcomer.name, is_claim=newcomer.is_claim)
        self._entrance.lobby.leave(key)
        if newcomer is not None and newcomer.token:
            return self._go(newcomer.token)
        if newcomer is None:  # it was told already, perhaps in another tab
            response: web.StreamResponse = _to("./")
        else:
            wrong = self._texts(request)(newcomer.refusal, name=newcomer.name)
            response = self._first_page(request, typed=newcomer.name, wrong=wrong, status=403)
        self._gate.forget(response, LOBBY)
        return response

    async def _manifest(self, request: web.Request) -> web.StreamResponse:
        start = request.query.get("start", "")
        return pages.manifest(self._texts(request), start if start in pages.STARTS else "")

    async def _leave(self, request: web.Request) -> web.StreamResponse:
        """Sign out `who`, for `then` who stays; without a name it is who waits in the lobby."""
        form = await self._gate.form(request)
        who, then = form.get("who", ""), form.get("then", "")
        if who:
            stays = next((name for name in self._here(request) if who_is(name) == then != who), None)
            response = _to("./") if stays is None else _to("desk", stays)
            self._gate.sign_out(request, response, who)
            return response
        self._entrance.lobby.leave(self._gate.cookie(request, LOBBY))
        self._sessions.feed.tell()
        response = _to("./")
        self._gate.forget(response, LOBBY)
        return response

    async def _link(self, request: web.Request) -> web.StreamResponse:
        """A link with a token. A right one is never refused: its 128 bits are not found by trying."""
        token = request.match_info["token"]
        ticket = self._tokens.of(token)
        if ticket is None:
            why = self._gate.tries.refusal(self._gate.address(request), is_right=False)
            key, status = {"often": ("serve.wrong.often", 429), "wrong": ("serve.wrong.link", 403)}[why]
            return pages.message(self._texts(request), key, status=status, up="../")
        page = {PUPIL: "come", WATCHER: "watch", TEACHER: "class"}[ticket.kind]
        response = pages.entering(self._texts(request), f"../{pages.of(page, ticket.name)}")
        self._gate.let_in(response, ticket.kind, token, ticket.name)
        return response

    # -- the desktop ---------------------------------------------------------------------------------------------------

    async def _desk(self, request: web.Request) -> web.StreamResponse:
        return self._page(request, PUPIL)

    async def _watch(self, request: web.Request) -> web.StreamResponse:
        return self._page(request, WATCHER)

    def _page(self, request: web.Request, kind: str) -> web.StreamResponse:
        """The page of a desktop; an address that does not say whose gets one that does, or the question."""
        ticket = self._gate.ticket(request, kind)
        if ticket is None and kind == PUPIL and "who" not in request.query and len(self._here(request)) > 1:
            return _to("./")
        if ticket is None:
            return pages.message(self._texts(request), "serve.wrong.stranger", status=403)
        if "who" not in request.query and not self._settings.proxied:
            return _to(request.path.rpartition("/")[2], ticket.name, request.query)
        return web.FileResponse(STATIC / "desk.html")

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        """`?watch=1` is the page of who only watches, `?mine=1` the teacher's desktop, whatever other cookies there are."""
        if not self._gate.is_from_here(request):
            return web.Response(status=403, text="This page does not come from this server.\n")
        own = {"watch": (WATCHER,), "mine": (TEACHER,)}
        kinds = next((own[key] for key in own if key in request.query), (PUPIL, WATCHER))
        ticket = next((found for kind in kinds if (found := self._gate.ticket(request, kind)) is not None), None)
        if ticket is None:
            return web.Response(status=403, text="No token.\n")
        if ticket.kind == PUPIL:
            self._sessions.note_address(ticket.name, self._gate.address(request))
        lang = pages.language_for(request, self._settings.lang)

        def is_good() -> bool:
            return self._gate.ticket(request, ticket.kind) == ticket

        desk = Ticket(TEACHER, TEACHERS) if ticket.kind == TEACHER else ticket
        return await socket.talk(request, self._sessions, desk, lang=lang, is_good=is_good, refused=self._refused)

    def _refused(self, name: str, error: Exception) -> None:
        reason = named_reason(error)
        if isinstance(error, IsolationError):
            reason = Texts(self._settings.lang)(error.words.key, **error.words.values)
        self._tell("serve.refused", name=name, reason=reason)


def _plain(word: str) -> bytes:
    """The word however an input method writes it: full-width letters are the same ones."""
    return unicodedata.normalize("NFKC", word).strip().encode(errors="replace")


def _to(page: str, name: str = "", more: Mapping[str, str] = MappingProxyType({})) -> web.Response:
    """The way to a page of ours, to a pupil's if there is a name."""
    return web.Response(status=303, headers={"Location": pages.of(page, name, more)})
