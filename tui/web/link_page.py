"""The page with the links of the class and their QR codes, to be printed: `links`, for the teacher's token only."""

from __future__ import annotations

from collections.abc import Callable
from html import escape

import segno
from aiohttp import web

from day6_tui.tui.locale import Texts
from day6_tui.tui.web import pages
from day6_tui.tui.web.gate import Gate
from day6_tui.tui.web.links import Links
from day6_tui.tui.web.tokens import PUPIL, TEACHER, WATCHER, Ticket


def routes(gate: Gate, links: Links, texts: Callable[[web.Request], Texts]) -> list[web.RouteDef]:
    """The addresses of the page and of its buttons."""

    async def show(request: web.Request) -> web.StreamResponse:
        if gate.ticket(request, TEACHER) is None:
            return pages.message(texts(request), "serve.wrong.stranger", status=403)
        return pages.page(texts(request), _body(texts(request), links), wide=True)

    async def make(request: web.Request) -> web.StreamResponse:
        """A new link for one pupil, or for who watches one."""
        if gate.ticket(request, TEACHER) is None:
            return pages.message(texts(request), "serve.wrong.stranger", status=403)
        form = await gate.form(request)
        kind, name = form.get("kind", ""), form.get("name", "")
        if kind in (PUPIL, WATCHER) and name in links.all_names():
            links.make(Ticket(kind, name))
            await links.keep()
        return web.Response(status=303, headers={"Location": "../links"})

    return [web.get("/links", show), web.post("/links/new", make)]


def _body(texts: Texts, links: Links) -> str:
    names = links.all_names()
    cards = "\n".join(_card(texts, links, name) for name in names)
    empty = "" if names else f"<p>{escape(texts('serve.links.none'))}</p>"
    return f'<p class="screen">{escape(texts("serve.links.what"))}</p>\n{empty}<div class="cards">\n{cards}\n</div>'


def _card(texts: Texts, links: Links, name: str) -> str:
    link = links.known(Ticket(PUPIL, name))
    watching = links.known(Ticket(WATCHER, name))
    parts = [f"<h2>{escape(name)}</h2>"]
    if link is None:
        parts.append(f'<p class="screen">{escape(texts("serve.links.unknown"))}</p>')
    else:
        parts += [qr(link), f"<p><code>{escape(link)}</code></p>"]
    if watching is not None:
        label = escape(texts("serve.links.watching"))
        parts.append(f'<p class="screen">{label} <code>{escape(watching)}</code></p>')
    parts += [_button(PUPIL, name, texts("serve.links.new")), _button(WATCHER, name, texts("serve.links.watch"))]
    return f"<section>{''.join(parts)}</section>"


def _button(kind: str, name: str, label: str) -> str:
    hidden = "".join(
        f'<input type="hidden" name="{key}" value="{escape(value)}">' for key, value in (("kind", kind), ("name", name))
    )
    return f'<form class="screen" method="post" action="links/new">{hidden}<button>{escape(label)}</button></form>'


def qr(link: str) -> str:
    """A picture of the link as SVG."""
    return str(segno.make(link, error="m", micro=False).svg_inline(scale=4, border=2))
