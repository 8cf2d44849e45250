"""The page with the links of the class and their QR codes, to be printed: `links`, for the teacher's token only.

What has the class `screen` is not printed: a slip of paper is a name, a picture and an address.
"""

from __future__ import annotations

from collections.abc import Callable
from html import escape

import segno
from aiohttp import web

from day6_core.reason import reason
from day6_tui.locale import Texts
from day6_tui.web import pages
from day6_tui.web.gate import Gate
from day6_tui.web.links import Links
from day6_tui.web.sessions import Sessions
from day6_tui.web.tokens import PUPIL, TEACHER, WATCHER, Ticket

ALL = "all"
"""What is asked for where it is a new link for every pupil of the list."""


def routes(gate: Gate, links: Links, sessions: Sessions, texts: Callable[[web.Request], Texts]) -> list[web.RouteDef]:
    """The addresses of the page and of its buttons."""

    async def show(request: web.Request) -> web.StreamResponse:
        if gate.ticket(request, TEACHER) is None:
            return pages.message(texts(request), "serve.wrong.stranger", status=403)
        return pages.page(texts(request), _body(texts(request), links), wide=True)

    async def make(request: web.Request) -> web.StreamResponse:
        """A new link for one pupil, for who watches one, or for all."""
        form = await gate.form(request)
        if gate.ticket(request, TEACHER) is None:
            return pages.message(texts(request), "serve.wrong.stranger", status=403)
        kind, name = form.get("kind", ""), form.get("name", "")
        if kind == ALL:
            links.make_all()
            for each in links.names:
                sessions.turn_out(each, "refused", kind=PUPIL)
        elif kind in (PUPIL, WATCHER) and name in links.all_names():
            links.make(Ticket(kind, name))
            sessions.turn_out(name, "refused", kind=kind)
        try:
            await links.keep()
        except OSError as error:  # the new links are good until the server ends
            return pages.message(texts(request), "serve.links.not_kept", status=507, up="../", reason=reason(error))
        return web.Response(status=303, headers={"Location": "../links"})

    return [web.get("/links", show), web.post("/links/new", make)]


def _body(texts: Texts, links: Links) -> str:
    names = links.all_names()
    parts = [f'<p class="screen"><a href="class">{escape(texts("serve.links.back"))}</a></p>']
    parts.append(f'<p class="screen">{escape(texts("serve.links.what"))}</p>')
    if links.are_local:
        parts.append(f'<p class="screen wrong">{escape(texts("serve.links.local"))}</p>')
    if len(links.names) > 1:
        parts.append(_asking(texts, "serve.links.all", ALL, count=len(links.names)))
    if not names:
        parts.append(f"<p>{escape(texts('serve.links.none'))}</p>")
    cards = "\n".join(_card(texts, links, name) for name in names)
    return "\n".join(parts) + f'\n<div class="cards">\n{cards}\n</div>'


def _card(texts: Texts, links: Links, name: str) -> str:
    """A slip; one without a link is of no use on paper."""
    link = links.known(Ticket(PUPIL, name))
    watching = links.known(Ticket(WATCHER, name))
    parts = [f"<h2>{escape(name)}</h2>"]
    if link is not None:
        parts += [qr(link), f"<p><code>{escape(link)}</code></p>"]
    else:
        why = texts("serve.links.unknown") if links.is_listed(name) else texts("serve.links.by_word")
        parts.append(f'<p class="screen">{escape(why)}</p>')
    if watching is not None:
        label = escape(texts("serve.links.watching"))
        parts.append(f'<p class="screen">{label} <code>{escape(watching)}</code></p>')
    parts.append(_asking(texts, "serve.links.new", PUPIL, name=name))
    parts.append(_asking(texts, "serve.links.watch", WATCHER, name=name))
    kind = ' class="screen"' if link is None else ""
    return f"<section{kind}>{''.join(parts)}</section>"


def _asking(texts: Texts, key: str, kind: str, *, name: str = "", count: int = 0) -> str:
    """A button behind a sentence that says what it does: nothing is lost by a wrong click, and no script is needed."""
    hidden = "".join(
        f'<input type="hidden" name="{field}" value="{escape(value)}">'
        for field, value in (("kind", kind), ("name", name))
    )
    return (
        f'<details class="screen"><summary>{escape(texts(key))}</summary>'
        f"<p>{escape(texts(f'{key}.sure', name=name, count=count))}</p>"
        f'<form method="post" action="links/new">{hidden}<button>{escape(texts(f"{key}.yes"))}</button></form></details>'
    )


def qr(link: str) -> str:
    """A picture of the link as SVG."""
    return str(segno.make(link, error="m", micro=False).svg_inline(scale=4, border=2))
