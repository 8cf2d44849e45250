"""`day6-tui serve`: reads the options, looks at the machine, and runs the server until it is told to end."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import os
import signal
import sys
from collections.abc import Callable

from day6_core.isolation import modes
from day6_core.isolation.cell import IsolationError, Phrase
from day6_core.isolation.modes import ModeOffer
from day6_core.language import language_of
from day6_core.reason import fault, named_reason
from day6_core.session.harmless import one_line
from day6_tui import turns
from day6_tui.locale import Texts
from day6_tui.web.options import is_loopback, parse
from day6_tui.web.places import isolation_before
from day6_tui.web.settings import ServerSettings
from day6_tui.web.told import told


class ServeRefused(Exception):
    """The server does not start; `words` say why."""

    def __init__(self, key: str, **values: str) -> None:
        super().__init__(key)
        self.words = Phrase(key, values)


def main(words: list[str]) -> int:
    """`day6-tui serve [OPTION …]`; returns the exit status."""
    language = language_of(os.environ, words)
    texts = Texts(language)
    settings = parse(words, language)
    tell = _teller(texts)
    try:
        if sys.platform == "win32":
            raise ServeRefused("serve.windows")
        _look_for_packages()
        offer = _offer(settings, texts, tell)
        _refuse_strangers(settings, offer)
        if settings.word_is_seen:
            tell("serve.word.seen")
        turns.keep_from_children()
        turns.take_short()
        return asyncio.run(_run(settings, offer, tell))
    except ServeRefused as error:
        return _fail(texts(error.words.key, **error.words.values), 2)
    except IsolationError as error:
        return _fail(texts(error.words.key, **error.words.values), 1)
    except OSError as error:
        return _fail(named_reason(error), 1)


def _fail(text: str, status: int) -> int:
    print(f"day6-tui: {one_line(text)}", file=sys.stderr)
    return status


def _look_for_packages() -> None:
    try:
        import aiohttp
        import segno
    except ImportError:
        raise ServeRefused("serve.no_packages") from None
    del aiohttp, segno


def _offer(settings: ServerSettings, texts: Texts, tell: Callable[..., None]) -> ModeOffer:
    """How pupils will be kept apart; why not better is told. Raises Refused where that is not to be had."""
    name = settings.isolation
    if name == "auto" and settings.proxied:
        name = "none"  # there is one pupil, in an account or a container of their own
    if name == "auto" and (before := isolation_before(settings.data)) is not None:
        # The homes belong to its users, and its desktops may still run.
        (offer,) = modes.survey((before,))
        if offer.mode is not None:
            tell("serve.as_before", name=before)
            return offer
    if name != "auto":
        (offer,) = modes.survey((name,))
        if offer.mode is None:
            raise ServeRefused("serve.no_mode", name=name, reason=_reason(offer, texts))
        return offer
    offers: list[ModeOffer] = []
    for each in modes.NAMES:
        offers += modes.survey((each,))
        if (mode := offers[-1].mode) is not None and mode.separates:
            return offers[-1]
    for offer in offers[:-1]:
        tell("serve.not_mode", name=offer.name, reason=_reason(offer, texts))
    return offers[-1]


def _reason(offer: ModeOffer, texts: Texts) -> str:
    return "" if offer.reason is None else texts(offer.reason.key, **offer.reason.values)


def _refuse_strangers(settings: ServerSettings, offer: ModeOffer) -> None:
    """Others get in only where pupils are kept apart, or where the user says that they may do all this user may."""
    separates = offer.mode is not None and offer.mode.separates
    if not (separates or settings.trust_pupils or settings.unix is not None or is_loopback(settings.host)):
        raise ServeRefused("serve.not_apart", name=offer.name, host=settings.host)


async def _run(settings: ServerSettings, offer: ModeOffer, tell: Callable[..., None]) -> int:
    from day6_tui.web.class_list import BadList
    from day6_tui.web.server import InUse, Server
    from day6_tui.web.tokens import BadTokens

    for name in ("aiohttp", "asyncio"):
        logging.getLogger(name).addHandler(_OneLine())
        logging.getLogger(name).propagate = False
    loop = asyncio.get_running_loop()
    is_to_end = asyncio.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, is_to_end.set)
    server = Server(settings, offer, tell)
    server.warm_up()
    try:
        await server.open()
    except BadList as error:
        raise ServeRefused(error.words.key, **error.words.values) from None
    except BadTokens as error:
        raise ServeRefused("serve.bad_tokens", file=str(error)) from None
    except InUse as error:
        raise ServeRefused("serve.in_use", folder=str(error)) from None
    await is_to_end.wait()
    await server.close()
    return 0


class _OneLine(logging.Handler):
    """Says what went wrong inside the server in one line; the class goes on."""

    def emit(self, record: logging.LogRecord) -> None:
        """Print a record that is a warning or worse."""
        error = record.exc_info[1] if record.exc_info else None
        reason = f" ({fault(error)})" if error is not None else ""
        if record.levelno >= logging.WARNING:
            with contextlib.suppress(OSError):
                print(f"day6-tui: {one_line(record.getMessage() + reason)}", file=sys.stderr, flush=True)


def _teller(texts: Texts) -> Callable[..., None]:
    """Prints texts of the catalogue, for whoever has started the server."""

    def tell(key: str, **values: object) -> None:
        with contextlib.suppress(OSError):  # nobody reads any more
            print(f"day6-tui: {one_line(told(texts, key, values))}", flush=True)

    return tell
