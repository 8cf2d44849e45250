"""The pages that are no terminal: plain HTML that works without a script."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from types import MappingProxyType
from urllib.parse import urlencode

from aiohttp import web

from day6_core.language import LANGUAGES
from day6_tui.locale import Texts
from day6_tui.web.names import who_is

LONGEST_TYPED = 64
"""Characters of the field for the name: more than a name may have, so that it is told and not cut."""


LOBBY_SECONDS = 3
"""After which who waits asks again, where a browser runs no scripts."""


def language_for(request: web.Request, default: str) -> str:
    """The language the browser asks for, if we have it."""
    asked = request.query.get("lang", "")
    if asked in LANGUAGES:
        return asked
    for part in request.headers.get("Accept-Language", "").lower().split(","):
        tag = part.partition(";")[0].strip()[:2]
        if tag in LANGUAGES:
            return tag
    return default


def language_tag(texts: Texts) -> str:
    """The language as browsers call it."""
    return "zh-CN" if texts.language == "zh" else "en"


def page(
    texts: Texts, body: str, *, status: int = 200, head: str = "", up: str = "", wide: bool = False
) -> web.Response:
    """A whole page; `body` is HTML. `up` leads from the page to where `static/` is."""
    language = language_tag(texts)
    kind = ' class="wide"' if wide else ""
    text = (
        f'<!doctype html>\n<html lang="{language}">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<title>day6-tui</title>\n<link rel="icon" href="{up}static/icon.svg" type="image/svg+xml">\n'
        f'<link rel="apple-touch-icon" href="{up}static/icons/whole-192.png">\n'
        f'<link rel="manifest" href="{up}manifest.webmanifest" crossorigin="use-credentials">\n'
        f'<link rel="stylesheet" href="{up}static/pages.css">\n{head}</head>\n'
        f"<body>\n<main{kind}>\n<h1>day6-tui</h1>\n{body}\n</main>\n</body>\n</html>\n"
    )
    return web.Response(text=text, content_type="text/html", status=status)


def message(
    texts: Texts, key: str, *, status: int, up: str = "", leads_back: bool = True, **values: object
) -> web.Response:
    """A page that says one thing; `leads_back`: to the start page."""
    back = f'<p><a href="{up}./">{escape(texts("serve.back"))}</a></p>' if leads_back else ""
    return page(texts, f"<p>{escape(texts(key, **values))}</p>\n{back}", status=status, up=up)


def of(page: str, name: str = "", more: Mapping[str, str] = MappingProxyType({})) -> str:
    """The address of a page, with whose it is: a browser may have several pupils."""
    query = urlencode({**more, "who": who_is(name)}) if name else urlencode(more)
    return f"{page}?{query}" if query else page


def start(
    texts: Texts,
    *,
    apart: str,
    asks_word: bool,
    here: Sequence[str],
    typed: str = "",
    wrong: str = "",
    status: int = 200,
) -> web.Response:
    """The first page: what this is, how pupils are kept apart, and the way in. `here` are those who are signed in in this
    browser, `typed` is the name that was tried last.
    """
    parts = [f"<p>{escape(texts('serve.start.what'))}</p>"]
    if wrong:
        parts.append(f'<p class="wrong" role="alert">{escape(wrong)}</p>')
    for name in here:
        parts.append(f"<p>{_way(texts('serve.start.go_on', name=name), name)}</p>")
        parts.append(_signing_out(texts("serve.start.leave", name=name), name))
    way = _entering(texts, typed, beside=bool(here)) if asks_word else f"<p>{escape(texts('serve.start.by_link'))}</p>"
    if here:
        is_open = " open" if wrong else ""
        way = f"<details{is_open}><summary>{escape(texts('serve.start.beside'))}</summary>\n{way}</details>"
    parts += [way, f'<p class="apart">{escape(apart)}</p>']
    return page(texts, "\n".join(parts), status=status)


def _entering(texts: Texts, typed: str, *, beside: bool) -> str:
    """The form for the class word; `beside`: whoever fills it in has seen who else is here."""
    return (
        '<form method="post" action="enter">\n'
        f'<label>{escape(texts("serve.start.word"))} <input name="word" required autofocus autocomplete="off" '
        'autocapitalize="none" spellcheck="false" maxlength="200"></label>\n'
        f'<label>{escape(texts("serve.start.name"))} <input name="name" required autocomplete="off" '
        f'maxlength="{LONGEST_TYPED}" value="{escape(typed[:LONGEST_TYPED])}"></label>\n'
        f"{'<input type=hidden name=beside>' * beside}<button>{escape(texts('serve.start.enter'))}</button>\n</form>"
    )


def _way(text: str, name: str) -> str:
    return f'<a class="go" href="{of("desk", name)}">{escape(text)}</a>'


def _signing_out(text: str, name: str, then: str = "") -> str:
    """A button: this pupil is signed out in this browser, and `then` goes on."""
    hidden = "".join(
        f'<input type="hidden" name="{key}" value="{who_is(value)}">'
        for key, value in (("who", name), ("then", then))
        if value
    )
    return f'<form class="plain" method="post" action="leave">{hidden}<button>{escape(text)}</button></form>'


def beside(texts: Texts, name: str, others: Sequence[str]) -> web.Response:
    """Somebody has come into a browser in which others are at work: may both stay?"""
    parts = [f"<p>{escape(texts('serve.beside.what', name=other))}</p>" for other in others]
    parts.append(f"<p>{_way(texts('serve.beside.both', name=name), name)}</p>")
    for other in others:
        parts.append(_signing_out(texts("serve.beside.instead", name=name, other=other), other, name))
        parts.append(_signing_out(texts("serve.beside.back", name=name, other=other), name, other))
    parts.append(f'<p class="apart">{escape(texts("serve.beside.note"))}</p>')
    return page(texts, "\n".join(parts))


def lobby(texts: Texts, name: str, *, is_claim: bool = False) -> web.Response:
    """Somebody waits for the teacher, perhaps as a pupil that there is already; the page asks again by itself."""
    key = "serve.lobby.claim" if is_claim else "serve.lobby.wait"
    body = (
        f'<p role="status">{escape(texts(key, name=name))}</p>\n'
        f'<p class="wrong" id="lost" role="alert" hidden>{escape(texts("serve.lobby.lost"))}</p>\n'
        f'<form method="post" action="leave"><button>{escape(texts("serve.lobby.leave"))}</button></form>'
    )
    # by a script, where there are scripts: a page that comes anew is read out anew, from its beginning
    again = f'<noscript><meta http-equiv="refresh" content="{LOBBY_SECONDS}"></noscript>\n'
    return page(texts, body, head=f'{again}<script type="module" src="static/waiting.js"></script>\n')


STARTS = {"": "./", "desk": "desk", "class": "class"}
"""Where the page begins that somebody has installed, by where it was installed."""

_ICONS = [
    {"src": "static/icon.svg", "type": "image/svg+xml", "sizes": "any", "purpose": "any"},
    *(
        {"src": f"static/icons/{kind}-{size}.png", "type": "image/png", "sizes": f"{size}x{size}", "purpose": purpose}
        for kind, purpose in (("round", "any"), ("whole", "maskable"))
        for size in (192, 512)
    ),
]


def manifest(texts: Texts, start: str) -> web.Response:
    """What makes the page installable (https://www.w3.org/TR/appmanifest/); browsers offer it on https and on this machine."""
    told = {
        "id": STARTS[start],
        "name": texts(f"serve.app.{start or 'desk'}"),
        "short_name": "day6",
        "description": texts("serve.start.what"),
        "lang": language_tag(texts),
        "start_url": STARTS[start],
        "scope": "./",
        "display": "standalone",
        "background_color": "#0c0c0c",
        "theme_color": "#1c2128",
        "icons": _ICONS,
    }
    return web.json_response(told, content_type="application/manifest+json")


def entering(texts: Texts, to: str) -> web.Response:
    """Goes on by itself. A redirect would still count as the other site's click, and the cookie would not be sent with it."""
    link = f'<p><a href="{escape(to)}">{escape(texts("serve.start.enter"))}</a></p>'
    return page(texts, link, head=f'<meta http-equiv="refresh" content="0; url={escape(to)}">\n', up="../")
