"""wget and curl: download a file from the web, as tutorials do. Only what the user names is requested."""

from __future__ import annotations

import os
import socket
import threading
import time
from collections.abc import Callable
from typing import NamedTuple
from urllib.parse import urlsplit

from day6_core.reason import reason
from day6_core.session.session import Session
from day6_core.session.threads import in_thread
from day6_core.shell.builtins.options import UsageError, parse
from day6_core.shell.builtins.text import write_named
from day6_core.shell.outside import asking

MOST_BYTES = 200_000_000
PATIENCE = 20.0
"""Timeout of a request, in wall clock seconds."""


class Response(NamedTuple):
    """A response: HTTP `status` (0 for none), the bytes, and a description of what went wrong before there was a response."""

    status: int
    reason: str
    body: bytes
    problem: str = ""
    unknown_host: bool = False


async def _fetch(session: Session, url: str) -> Response:
    """Send a request on a thread of its own; Ctrl-C gives up waiting."""
    given_up = threading.Event()
    session.defer(given_up.set)
    return await in_thread(lambda: _ask(url, given_up))


def _ask(url: str, given_up: threading.Event) -> Response:
    from http.client import HTTPException
    from urllib.error import HTTPError, URLError
    from urllib.request import Request, urlopen

    body = bytearray()
    try:
        with urlopen(Request(url, headers={"User-Agent": "day6-tui"}), timeout=PATIENCE) as source:
            while not given_up.is_set() and (piece := source.read(65536)):
                body += piece
                if len(body) > MOST_BYTES:
                    return Response(0, "", b"", f"more than {MOST_BYTES} bytes")
            return Response(source.status, source.reason, bytes(body))
    except HTTPError as error:
        with error:
            return Response(error.code, str(error.reason), error.read())
    except URLError as error:
        unknown = isinstance(error.reason, socket.gaierror)
        return Response(0, "", b"", getattr(error.reason, "strerror", None) or str(error.reason), unknown)
    except (OSError, HTTPException, ValueError) as error:
        return Response(0, "", b"", reason(error))


def _address(text: str) -> str | None:
    """The URL with its scheme, as these tools complete it; None for one they do not fetch here."""
    url = text if "://" in text else f"http://{text}"
    parts = urlsplit(url)
    return url if parts.scheme in ("http", "https") and parts.hostname else None


def _saved(names: list[str]) -> list[str]:
    """Where files may be written: the working directory, and the operands that are not URLs."""
    return [".", *(name for name in names if "://" not in name)]


@asking(_saved)
async def wget(session: Session) -> int:
    """`wget [-q] [-O FILE] [-P FOLDER] ADDRESS …`."""
    try:
        options, urls = parse(
            session.argv, "qcN", "OP", {"--quiet": "q", "--output-document": "O", "--no-check-certificate": "c"}
        )
    except UsageError as error:
        session.print_error(f"wget: {error}")
        return 2
    if not urls:
        session.print_error("wget: missing URL\nUsage: wget [OPTION]... [URL]...")
        return 1
    report = _discard if "q" in options else session.print_error
    status = 0
    for text in urls:
        url = _address(text)
        if url is None:
            report(f"{text}: Unsupported scheme.")
            status = 1
            continue
        report(time.strftime(f"--%Y-%m-%d %H:%M:%S--  {url.replace('%', '%%')}"))
        response = await _fetch(session, url)
        name = options.get("O") or os.path.join(
            options.get("P", ""), os.path.basename(urlsplit(url).path) or "index.html"
        )
        status = await _wget_end(session, url, name, response, report) or status
    return status


def _discard(text: object) -> None:
    """Report nothing, as `wget -q`."""


async def _wget_end(session: Session, url: str, name: str, response: Response, report: Callable[[object], None]) -> int:
    if response.unknown_host:
        session.print_error(f"wget: unable to resolve host address ‘{urlsplit(url).hostname}’")
        return 4
    if response.problem:
        report(f"failed: {response.problem}.")
        return 4
    report(f"HTTP request sent, awaiting response... {response.status} {response.reason}")
    if response.status >= 400:
        report(time.strftime(f"%Y-%m-%d %H:%M:%S ERROR {response.status}: {response.reason}.\n"))
        return 8
    if name == "-":
        session.stdout.write(response.body.decode("utf-8", "surrogateescape"))
        return 0
    try:
        await write_named(session, name, response.body)
    except OSError as error:
        session.print_error(f"{name}: {error.strerror}")
        return 3
    report(f"Saving to: ‘{name}’\n")
    report(time.strftime(f"%Y-%m-%d %H:%M:%S - ‘{name}’ saved [{len(response.body)}]\n"))
    return 0


@asking(_saved)
async def curl(session: Session) -> int:
    """`curl [-sSLf] [-o FILE | -O] ADDRESS`."""
    try:
        options, urls = parse(
            session.argv, "sSLfOIk", "oH", {"--output": "o", "--location": "L", "--silent": "s", "--fail": "f"}
        )
    except UsageError as error:
        session.print_error(f"curl: {str(error).splitlines()[0]}\ncurl: try 'curl --help' for more information")
        return 2
    if not urls:
        session.print_error("curl: (2) no URL specified")
        return 2
    quiet = "s" in options and "S" not in options
    for text in urls:
        url = _address(text)
        if url is None:
            return _curl_fails(session, 1, f'Protocol "{text.partition("://")[0]}" not supported', quiet)
        response = await _fetch(session, url)
        host = urlsplit(url).hostname
        if response.unknown_host:
            return _curl_fails(session, 6, f"Could not resolve host: {host}", quiet)
        if response.problem:
            return _curl_fails(session, 7, f"Failed to connect to {host}: {response.problem}", quiet)
        if response.status >= 400 and "f" in options:
            return _curl_fails(session, 22, f"The requested URL returned error: {response.status}", quiet)
        name = options.get("o") or (os.path.basename(urlsplit(url).path) if "O" in options else "")
        if not name:
            session.stdout.write(response.body.decode("utf-8", "surrogateescape"))
            continue
        try:
            await write_named(session, name, response.body)
        except OSError as error:
            return _curl_fails(session, 23, f"Failure writing output to destination: {name}: {error.strerror}", quiet)
    return 0


def _curl_fails(session: Session, number: int, text: str, quiet: bool) -> int:
    if not quiet:
        session.print_error(f"curl: ({number}) {text}")
    return number
