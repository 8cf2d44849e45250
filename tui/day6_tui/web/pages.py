"""The pages that are no terminal: plain HTML that works without a script."""

from __future__ import annotations

from html import escape

from aiohttp import web

from day6_core.language import LANGUAGES
from day6_tui.locale import Texts

LONGEST_TYPED = 64
"""Characters of the field for the name: more than a name may have, so that it is told and not cut."""


LOBBY_SECONDS = 3
"""After which who waits asks again."""


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


def page(
    texts: Texts, body: str, *, status: int = 200, head: str = "", up: str = "", wide: bool = False
) -> web.Response:
    """A whole page; `body` is HTML. `up` leads from the page to where `static/` is."""
    language = "zh-CN" if texts.language == "zh" else "en"
    kind = ' class="wide"' if wide else ""
    text = (
        f'<!doctype html>\n<html lang="{language}">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<title>day6-tui</title>\n<link rel="icon" href="{up}static/icon.svg" type="image/svg+xml">\n'
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


def start(
    texts: Texts, *, apart: str, asks_word: bool, name: str | None, typed: str = "", wrong: str = "", status: int = 200
) -> web.Response:
    """The first page: what this is, how pupils are kept apart, and the way in. `typed` is the name that was tried last."""
    parts = [f"<p>{escape(texts('serve.start.what'))}</p>"]
    if name is not None:
        parts.append(
            f'<p><a class="go" href="desk">{escape(texts("serve.start.go_on", name=name))}</a></p>\n'
            f'<form method="post" action="leave"><button>{escape(texts("serve.start.leave", name=name))}</button></form>'
        )
    elif asks_word:
        parts.append(
            '<form method="post" action="enter">\n'
            f'<label>{escape(texts("serve.start.word"))} <input name="word" type="password" required autofocus '
            'autocomplete="off" maxlength="200"></label>\n'
            f'<label>{escape(texts("serve.start.name"))} <input name="name" required autocomplete="off" '
            f'maxlength="{LONGEST_TYPED}" value="{escape(typed[:LONGEST_TYPED])}"></label>\n'
            f"<button>{escape(texts('serve.start.enter'))}</button>\n</form>"
        )
    else:
        parts.append(f"<p>{escape(texts('serve.start.by_link'))}</p>")
    if wrong:
        parts.insert(1, f'<p class="wrong" role="alert">{escape(wrong)}</p>')
    parts.append(f'<p class="apart">{escape(apart)}</p>')
    return page(texts, "\n".join(parts), status=status)


def lobby(texts: Texts, name: str) -> web.Response:
    """Somebody waits for the teacher; the page asks again by itself."""
    body = (
        f'<p role="status">{escape(texts("serve.lobby.wait", name=name))}</p>\n'
        f'<form method="post" action="leave"><button>{escape(texts("serve.lobby.leave"))}</button></form>'
    )
    again = f'<meta http-equiv="refresh" content="{LOBBY_SECONDS}">\n'
    return page(texts, body, head=again)


def entering(texts: Texts, to: str) -> web.Response:
    """Goes on by itself. A redirect would still count as the other site's click, and the cookie would not be sent with it."""
    link = f'<p><a href="{escape(to)}">{escape(texts("serve.start.enter"))}</a></p>'
    return page(texts, link, head=f'<meta http-equiv="refresh" content="0; url={escape(to)}">\n', up="../")
