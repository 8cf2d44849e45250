"""The WebSocket of a tab. What it says is in `_obey`; anything else closes it with a plain reason."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from typing import Any

from aiohttp import WSCloseCode, WSMsgType, web

from day6_core.isolation.cell import IsolationError
from day6_tui.web import connections
from day6_tui.web.in_time import stop
from day6_tui.web.session import MOST_UNTYPED, clamped
from day6_tui.web.sessions import Full, Sessions
from day6_tui.web.tokens import WATCHER, Ticket
from day6_tui.web.viewer import Viewer

LONGEST_FRAME = 64 << 10
"""Bytes; more is no typing."""

BEAT = 20.0
"""Seconds between two signs of life that are asked of the browser: a proxy cuts what is silent for a minute."""


Refused = Callable[[str, Exception], None]
"""Tells the server's user why a pupil got no desktop."""

LAST_SECONDS = 2.0
"""What a browser gets to take the last words."""


class Nonsense(Exception):
    """The browser said what no page of ours says; the message is the reason it is told."""


async def talk(
    request: web.Request,
    sessions: Sessions,
    ticket: Ticket,
    *,
    lang: str,
    is_good: Callable[[], bool],
    refused: Refused,
) -> web.StreamResponse:
    """Serve one tab until one of both leaves. `is_good`: whether the ticket still is, after what is awaited before."""
    ws = web.WebSocketResponse(timeout=LAST_SECONDS, max_msg_size=LONGEST_FRAME, heartbeat=BEAT, compress=False)
    await ws.prepare(request)
    connections.keep(request)
    name, read_only = ticket.name, ticket.kind == WATCHER
    viewer = Viewer(ws, _asked_size(request), read_only=read_only, lang=lang)
    await viewer.say(t="hello", name=name, read_only=read_only, lang=lang)
    columns, rows, _, _ = viewer.size
    await viewer.say(t="size", cols=columns, rows=rows)
    sending = asyncio.create_task(viewer.run())
    try:
        if not is_good():
            viewer.bye("refused")
        sessions.background.begin("serve.failed.start", _open(sessions, name, viewer, refused))
        code, reason = await _exchange(ws, viewer, sending)
    finally:
        sending.cancel()
        viewer.bye("gone")
        await sessions.leave(name, viewer)
        await asyncio.gather(sending, return_exceptions=True)
    await ws.close(code=code, message=reason.encode())
    return ws


async def _open(sessions: Sessions, name: str, viewer: Viewer, refused: Refused) -> None:
    """Have the desktop shown, which may have to be started, after others; the tab may go meanwhile."""
    why = "refused"
    try:
        await sessions.show(name, viewer)
        why = "server"  # which ends, if there is no desktop
    except Full:
        why = "full"
    except (IsolationError, OSError) as error:
        refused(name, error)
    finally:
        if viewer.session is None:
            viewer.bye(why)


async def _exchange(ws: web.WebSocketResponse, viewer: Viewer, sending: asyncio.Task[str]) -> tuple[int, str]:
    """Carry to and fro until one of both leaves; return how to close.

    Reading ends before the socket is closed: aiohttp would else not wait for the browser's answer, and the last words get lost.
    """
    listening = asyncio.create_task(_listen(ws, viewer))
    try:
        await asyncio.wait({sending, listening}, return_when=asyncio.FIRST_COMPLETED)
        if not listening.done():
            return WSCloseCode.OK, await _last_words(sending)
        listening.result()
        return WSCloseCode.OK, ""
    except Nonsense as nonsense:
        return WSCloseCode.POLICY_VIOLATION, str(nonsense)
    finally:
        await stop(listening)


async def _last_words(sending: asyncio.Task[str]) -> str:
    """Wait until the last words were sent, for a while; return why it is over."""
    await asyncio.wait({sending}, timeout=LAST_SECONDS)
    try:
        return sending.result() if sending.done() else ""
    except ConnectionError:
        return ""


def _asked_size(request: web.Request) -> tuple[int, int, int, int]:
    """The size in the address; what is no number counts as not given."""
    numbers = []
    for key, default in (("cols", 80), ("rows", 24), ("w", 0), ("h", 0)):
        text = request.query.get(key, "")
        numbers.append(int(text) if text.isascii() and text.isdigit() and len(text) < 9 else default)
    return clamped(*numbers)


async def _listen(ws: web.WebSocketResponse, viewer: Viewer) -> None:
    async for message in ws:
        if message.type == WSMsgType.BINARY:
            if not viewer.read_only:
                _type(viewer, message.data)
        elif message.type == WSMsgType.TEXT:
            await _obey(_parsed(message.data), viewer)


def _type(viewer: Viewer, keys: bytes) -> None:
    session = viewer.session
    try:
        if session is None:
            if len(viewer.early) > MOST_UNTYPED:
                raise BlockingIOError
            viewer.early += keys
        elif session.writer is viewer:
            session.type(keys)
    except BlockingIOError:
        raise Nonsense("typed too much") from None


def _parsed(text: str) -> dict[str, Any]:
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        raise Nonsense("not JSON") from None
    if not isinstance(found, dict):
        raise Nonsense("not an object")
    return found


def _number(found: dict[str, Any], key: str) -> int:
    value = found.get(key, 0)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not abs(value) < 2**53:
        raise Nonsense(f"{key} is not a number")
    return int(value)


async def _obey(found: dict[str, Any], viewer: Viewer) -> None:
    what = found.get("t")
    if what == "ack":
        viewer.acknowledge(_number(found, "bytes"))
    elif what == "ping":
        await viewer.say(t="pong", n=_number(found, "n"))
    elif what == "size":
        viewer.size = clamped(*(_number(found, key) for key in ("cols", "rows", "w", "h")))
        if not viewer.read_only:
            await viewer.say(t="size", cols=viewer.size[0], rows=viewer.size[1])
        session = viewer.session
        if session is None:
            return
        if session.writer is viewer or (session.writer is None and session.watchers[:1] == [viewer]):
            session.resize()
    else:
        raise Nonsense("unknown message")
