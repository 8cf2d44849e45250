"""The server: its parts, in the order in which they begin and end."""

from __future__ import annotations

import ssl
from collections.abc import Callable

from aiohttp import web

from day6_tui.core.isolation.modes import Offer
from day6_tui.tui.locale import Texts
from day6_tui.tui.web.application import Application
from day6_tui.tui.web.places import Places
from day6_tui.tui.web.sessions import Sessions
from day6_tui.tui.web.settings import Settings
from day6_tui.tui.web.tokens import Tokens

CLOSE_SECONDS = 3.0
"""What open sockets get to say goodbye."""


class Server:
    """What `day6-tui serve` runs."""

    def __init__(self, settings: Settings, offer: Offer, texts: Texts, tell: Callable[[str], None]) -> None:
        assert offer.mode is not None
        self._settings = settings
        self._texts = texts
        self._tell = tell
        self._offer = offer
        self._places = Places(settings.data, offer.mode)
        self._tokens = Tokens(self._places.server / "tokens.json")
        self._sessions = Sessions(settings, self._places, offer.mode, tell)
        self._runner: web.AppRunner | None = None

    async def open(self) -> None:
        """Begin to serve, and say where. Raises OSError, BadTokens."""
        self._places.make()
        self._tokens.load()
        application = Application(self._settings, self._tokens, self._sessions, self._offer.what_it_is)
        self._runner = web.AppRunner(application.build(), access_log=None, handle_signals=False)
        await self._runner.setup()
        site = await self._listen(self._runner)
        what = self._offer.what_it_is
        self._tell(self._texts("serve.apart", what=self._texts(what.key, **what.values)))
        self._tell(self._texts("serve.at", address=site))

    async def _listen(self, runner: web.AppRunner) -> str:
        settings = self._settings
        if settings.unix is not None:
            await web.UnixSite(runner, str(settings.unix)).start()
            return str(settings.unix)
        secure: ssl.SSLContext | None = None
        if settings.certificate is not None:
            secure = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
            secure.load_cert_chain(settings.certificate, settings.key)
        await web.TCPSite(runner, settings.host, settings.port, ssl_context=secure).start()
        port = runner.addresses[0][1]
        host = f"[{settings.host}]" if ":" in settings.host else settings.host
        return settings.base_url or f"http{'s' if secure else ''}://{host}:{port}/"

    async def close(self) -> None:
        """End the desktops in order, and then the server."""
        if not self._settings.keep:
            await self._sessions.end_all("server")
        if self._runner is not None:
            await self._runner.cleanup()
