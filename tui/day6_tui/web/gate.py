"""Who may in: the cookie, where a request comes from, under which name the server was called; and what every answer says."""

from __future__ import annotations

import asyncio
import ipaddress
import os
import socket
from collections.abc import Awaitable, Callable
from urllib.parse import parse_qsl, urlsplit
from zlib import crc32

from aiohttp import web

from day6_core.classroom.homes import same_name
from day6_tui.locale import Texts
from day6_tui.web import connections, pages
from day6_tui.web.in_time import in_time
from day6_tui.web.names import who_is
from day6_tui.web.places import login_name
from day6_tui.web.settings import ServerSettings
from day6_tui.web.tokens import PUPIL, Ticket, Tokens
from day6_tui.web.tries import Tries

Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]

COOKIE_SECONDS = 30 * 24 * 3600
"""How long a browser remembers who it is."""

_POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self' ws://{host} wss://{host}; "
    "worker-src 'self' blob:; manifest-src 'self'; form-action 'self'; base-uri 'none'; frame-ancestors {frames}"
)
"""No script but ours. The terminal needs styles of its own making and WebAssembly for pictures (xterm.js and its image addon)."""

MOST_FIELDS = 10
"""Of a form."""

LOOPBACK_NAMES = ("localhost", "127.0.0.1", "::1")


class Gate:
    """Judges requests. Nothing is told to who has no token."""

    def __init__(self, settings: ServerSettings, tokens: Tokens) -> None:
        self._settings = settings
        self._tokens = tokens
        self.tries = Tries()
        self._cookie = f"day6-{crc32(os.fsencode(settings.data)):08x}"
        """Servers on other ports of this machine get the same cookies, so each has a name of its own."""
        self._names = {*LOOPBACK_NAMES, socket.gethostname().lower(), f"{socket.gethostname().lower()}.local"}
        self._names |= {name for name in (urlsplit(settings.base_url).hostname, settings.host.lower()) if name}

    def tickets(self, request: web.Request, kind: str) -> list[Ticket]:
        """Everybody of this kind who is signed in in this browser; nobody is a stranger's."""
        if self._settings.proxied:
            return [Ticket(PUPIL, login_name())] if kind == PUPIL else []
        found = (self._tokens.of(value) for name, value in request.cookies.items() if self._is_cookie(name, kind))
        good = [ticket for ticket in found if ticket is not None and ticket.kind == kind]
        return list({same_name(ticket.name): ticket for ticket in good}.values())

    def ticket(self, request: web.Request, kind: str) -> Ticket | None:
        """Who this is. A tab's address says whose it is (`who`), for there may be several pupils in one browser; None for a
        stranger, and where it could be this one or that. A teacher can try a pupil's link beside the class.
        """
        found = self.tickets(request, kind)
        if "who" in request.query:
            found = [ticket for ticket in found if who_is(ticket.name) == request.query["who"]]
        return found[0] if len(found) == 1 else None

    def cookie(self, request: web.Request, kind: str) -> str:
        """What the browser was told to remember of this kind, of which it has one; "" if nothing."""
        return request.cookies.get(f"{self._cookie}-{kind}", "")

    def _is_cookie(self, name: str, kind: str) -> bool:
        """Pupils and who watches one have a cookie for each name; one without was made by an older server."""
        return f"{name}-".startswith(f"{self._cookie}-{kind}-")

    def let_in(self, response: web.StreamResponse, kind: str, token: str, name: str = "") -> None:
        """Have the browser remember the token, out of reach of scripts and of other sites."""
        response.set_cookie(
            f"{self._cookie}-{kind}-{who_is(name)}" if name else f"{self._cookie}-{kind}",
            token,
            max_age=COOKIE_SECONDS,
            httponly=True,
            samesite="Strict",
            secure=self._is_secure,
            path=self._path,
        )

    def forget(self, response: web.StreamResponse, kind: str) -> None:
        """Have the browser forget what it has one of."""
        response.del_cookie(f"{self._cookie}-{kind}", path=self._path)

    def sign_out(self, request: web.Request, response: web.StreamResponse, who: str) -> None:
        """Have the browser forget this pupil."""
        for cookie, value in request.cookies.items():
            ticket = self._tokens.of(value) if self._is_cookie(cookie, PUPIL) else None
            if ticket is not None and who_is(ticket.name) == who:
                response.del_cookie(cookie, path=self._path)

    @property
    def _path(self) -> str:
        return urlsplit(self._settings.base_url).path or "/"

    @property
    def _is_secure(self) -> bool:
        return self._settings.certificate is not None or self._settings.base_url.startswith("https:")

    def address(self, request: web.Request) -> str:
        """Where somebody calls from; behind a proxy all are one."""
        return request.remote or "?"

    # -- what a page of another site could make a browser do ---------------------------------------------------------

    def is_called_by_name(self, request: web.Request) -> bool:
        """Whether the browser means this server, and not a name that somebody lets point to it (DNS rebinding)."""
        if self._settings.proxied or self._settings.unix is not None:
            return True
        name = (_host_name(request.headers.get("Host", "")) or "").lower()
        return name in self._names or _is_address(name)

    def is_from_here(self, request: web.Request) -> bool:
        """Whether a page of ours sent this; browsers say that with every WebSocket and every form."""
        try:
            origin = urlsplit(request.headers.get("Origin", ""))
        except ValueError:
            return False
        if origin.scheme not in ("http", "https") or not origin.netloc:
            return False
        if origin.netloc.lower() == request.headers.get("Host", "").lower():
            return True
        base = urlsplit(self._settings.base_url)
        if base.netloc:
            return (origin.scheme, origin.netloc.lower()) == (base.scheme, base.netloc.lower())
        return self._settings.proxied and origin.netloc.lower() == request.headers.get("X-Forwarded-Host", "").lower()

    async def form(self, request: web.Request) -> dict[str, str]:
        """Read what a form of ours sends. Whatever is judged, is judged after this: others may come while it is awaited.

        Raises HTTPBadRequest for anything else, HTTPRequestEntityTooLarge, HTTPRequestTimeout.
        """
        connection = connections.connection_of(request)
        if connection is not None:
            connection.await_more()
        try:
            if request.content_type != "application/x-www-form-urlencoded":
                raise ValueError(request.content_type)
            data = await in_time(request.read(), connections.BODY_SECONDS)
            return dict(parse_qsl(data.decode(), keep_blank_values=True, max_num_fields=MOST_FIELDS))
        except ValueError:
            raise web.HTTPBadRequest(text="This form does not belong to this server.\n") from None
        except ConnectionError:  # nobody is there any more to be told
            raise web.HTTPBadRequest from None
        except asyncio.TimeoutError:
            raise web.HTTPRequestTimeout(text="The form did not come.\n", headers={"Connection": "close"}) from None
        finally:
            if connection is not None:
                connection.answer()

    async def body(self, request: web.Request, most: int) -> bytes | None:
        """Read what a page of ours sends, of at most so many bytes; None if it is more. Raises HTTPRequestTimeout."""
        connection = connections.connection_of(request)
        if connection is not None:
            connection.await_more()
        data = bytearray()
        try:
            while piece := await in_time(request.content.readany(), connections.BODY_SECONDS):
                data += piece
                if len(data) > most:
                    return None
            return bytes(data)
        except asyncio.TimeoutError:
            raise web.HTTPRequestTimeout(text="The file did not come.\n", headers={"Connection": "close"}) from None
        finally:
            if connection is not None:
                connection.answer()

    # -- what every answer says --------------------------------------------------------------------------------------

    @web.middleware
    async def guard(self, request: web.Request, handler: Handler) -> web.StreamResponse:
        """Refuse what does not come from our pages, and forbid what our pages never do."""
        connection = connections.connection_of(request)
        if connection is not None:
            connection.answer()
        response = await self._judged(request, handler)
        if connection is not None and not isinstance(response, web.FileResponse):  # which takes its time
            connection.await_more()
        return response

    async def _judged(self, request: web.Request, handler: Handler) -> web.StreamResponse:
        texts = Texts(pages.language_for(request, self._settings.lang))
        if not self.is_called_by_name(request):
            return pages.message(texts, "serve.wrong.host", status=421, leads_back=False)
        if request.method not in ("GET", "HEAD") and not self.is_from_here(request):
            return web.Response(status=403, text="This form does not come from this server.\n")
        try:
            return await handler(request)
        except (web.HTTPNotFound, web.HTTPMethodNotAllowed) as error:
            up = "../" * (request.path.count("/") - 1)
            return pages.message(texts, "serve.wrong.address", status=error.status, up=up)

    async def sign(self, request: web.Request, response: web.StreamResponse) -> None:
        """Add the headers to an answer before it is sent."""
        frames = "'self'" if self._settings.proxied else "'none'"
        host = request.headers.get("Host", "")
        plain = host if all(letter.isalnum() or letter in "-.:[]" for letter in host) else ""
        policy = _POLICY.format(host=plain or "localhost", frames=frames)
        response.headers.setdefault("Content-Security-Policy", policy)
        response.headers["X-Content-Type-Options"] = "nosniff"
        response.headers["Referrer-Policy"] = (
            "same-origin"  # with "no-referrer", forms would say they come from nowhere
        )
        response.headers["Cross-Origin-Opener-Policy"] = "same-origin"
        response.headers["Cross-Origin-Resource-Policy"] = "same-origin"
        response.headers.setdefault("Cache-Control", "no-store")
        response.headers["Server"] = "day6-tui"


def _host_name(host: str) -> str | None:
    try:
        return urlsplit(f"//{host}").hostname
    except ValueError:
        return None


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
