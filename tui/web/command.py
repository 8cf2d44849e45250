"""`day6-tui serve`: reads the options, looks at the machine, and runs the server until it is told to end."""

from __future__ import annotations

import asyncio
import signal
import sys
from pathlib import Path

from day6_tui.core.isolation import modes
from day6_tui.core.isolation.modes import Offer
from day6_tui.core.link.paths import LinkError
from day6_tui.core.session.harmless import one_line
from day6_tui.tui.command_line import language_of
from day6_tui.tui.locale import Texts
from day6_tui.tui.web.options import parse
from day6_tui.tui.web.settings import Settings

LOOPBACK = ("127.0.0.1", "localhost", "::1")


class Refused(Exception):
    """The server does not start; the message is for the user."""


def main(words: list[str]) -> int:
    """`day6-tui serve [OPTION …]`; returns the exit status."""
    language = language_of(words)
    texts = Texts(language)
    settings = parse(words, language)
    if sys.platform == "win32":
        return _refuse(texts("serve.windows"), 2)
    try:
        import aiohttp  # noqa: F401
    except ImportError:
        return _refuse(texts("serve.no_aiohttp"), 2)
    try:
        offer = _offer(settings, texts)
        return asyncio.run(_run(settings, offer, texts))
    except Refused as error:
        return _refuse(str(error), 2)
    except (LinkError, OSError) as error:
        return _refuse(f"{error.filename}: {error.strerror}" if getattr(error, "filename", None) else str(error), 1)


def _refuse(text: str, status: int) -> int:
    print(f"day6-tui: {one_line(text)}", file=sys.stderr)
    return status


def _offer(settings: Settings, texts: Texts) -> Offer:
    """How pupils will be kept apart. Raises Refused where that is not to be had."""
    if settings.isolation != "auto":
        (offer,) = modes.survey((settings.isolation,))
        if offer.mode is None:
            reason = "" if offer.reason is None else texts(offer.reason.key, **offer.reason.values)
            raise Refused(texts("serve.no_mode", name=offer.name, reason=reason))
        return offer
    offers = [offer for offer in modes.survey() if offer.mode is not None]
    return next((offer for offer in offers if offer.mode is not None and offer.mode.separates), offers[-1])


async def _run(settings: Settings, offer: Offer, texts: Texts) -> int:
    assert sys.platform != "win32"  # `main` has said so
    from day6_tui.tui.web.server import Server

    loop = asyncio.get_running_loop()
    told = asyncio.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, told.set)
    server = Server(settings, offer, texts, _tell)
    await server.open()
    try:
        await told.wait()
    finally:
        await server.close()
    return 0


def _tell(text: str) -> None:
    print(f"day6-tui: {one_line(text)}", flush=True)


def data_of(given: Path | None) -> Path:
    """Where the files of the class are, by its one true name."""
    from day6_tui.core.places import default_home

    return (default_home().parent / "class" if given is None else given).expanduser().resolve()
