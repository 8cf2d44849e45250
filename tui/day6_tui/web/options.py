"""The options of `day6-tui serve`, explained in the user's language."""

from __future__ import annotations

import argparse
import ipaddress
import os
from functools import partial
from pathlib import Path
from urllib.parse import urlsplit

from day6_core.graph.domain import VARIABLE, DomainError, domain_from_text
from day6_core.isolation.cell import Limits
from day6_core.isolation.modes import NAMES
from day6_core.language import LANGUAGES
from day6_core.places import default_home
from day6_tui.command_line import folder, parser_with_options
from day6_tui.locale import Texts
from day6_tui.web.settings import ServerSettings

SHORTEST_WORD = 4
"""Characters of the class word: two tries a second are all anybody gets."""


def build_parser(language: str = "en") -> argparse.ArgumentParser:
    """The options of the server."""
    texts = Texts(language)
    parser, options = parser_with_options(texts, "day6-tui serve", "cli.serve")
    add = options.add_argument
    add("--class", dest="class_file", type=Path, metavar="FILE.csv", help=texts("cli.serve.class"))
    add("--new-links", action="store_true", help=texts("cli.serve.new_links"))
    add("--word", type=_word, metavar="WORD", help=texts("cli.serve.word"))
    add("--data", type=Path, metavar="DIR", help=texts("cli.serve.data"))
    add("--lessons", type=folder, metavar="DIR", help=texts("cli.lessons"))
    add("--lang", choices=LANGUAGES, help=texts("cli.serve.lang"))
    add("--most", type=partial(_number, least=1, most=1000), default=40, metavar="N", help=texts("cli.serve.most"))
    add("--idle", type=_minutes, default=120.0, metavar="MIN", help=texts("cli.serve.idle"))
    add("--keep", action="store_true", help=texts("cli.serve.keep"))
    add("--isolation", choices=("auto", *NAMES), default="auto", help=texts("cli.serve.isolation"))
    most = Limits()
    mb = partial(_number, least=16, most=1_000_000)
    add("--memory", type=mb, default=most.memory >> 20, metavar="MB", help=texts("cli.serve.memory"))
    add("--disk", type=mb, default=most.disk >> 20, metavar="MB", help=texts("cli.serve.disk"))
    number = partial(_number, least=16, most=100_000)
    add("--processes", type=number, default=most.processes, metavar="N", help=texts("cli.serve.processes"))
    weight = partial(_number, least=1, most=10_000)
    add("--cpu-weight", type=weight, default=most.cpu_weight, metavar="N", help=texts("cli.serve.cpu_weight"))
    add("--trust-pupils", action="store_true", help=texts("cli.serve.trust"))
    add("--host", default="127.0.0.1", metavar="ADDRESS", help=texts("cli.serve.host"))
    add("--port", type=partial(_number, least=0, most=65535), default=8006, metavar="N", help=texts("cli.serve.port"))
    add("--cert", dest="certificate", type=Path, metavar="FILE", help=texts("cli.serve.cert"))
    add("--key", type=Path, metavar="FILE", help=texts("cli.serve.key"))
    add("--base-url", type=_address, metavar="URL", help=texts("cli.serve.base_url"))
    add("--unix", type=Path, metavar="SOCKET", help=texts("cli.serve.unix"))
    add("--proxied", action="store_true", help=texts("cli.serve.proxied"))
    add("--home", type=Path, metavar="DIR", help=texts("cli.serve.home"))
    return parser


def parse(words: list[str], language: str) -> ServerSettings:
    """The settings; a wrong word ends the program with status 2, as argparse does."""
    parser = build_parser(language)
    found = vars(parser.parse_args(words))
    if found["key"] is not None and found["certificate"] is None:
        parser.error("argument --key: needs --cert")
    if found["new_links"] and found["class_file"] is None:
        parser.error("argument --new-links: needs --class")
    if found["proxied"] and (found["class_file"] or found["word"]):
        parser.error("argument --proxied: not allowed with --class or --word")
    if found["home"] is not None and not found["proxied"]:
        parser.error("argument --home: needs --proxied")
    if found["proxied"] and found["unix"] is None:  # any user of this machine reaches a port
        parser.error("argument --proxied: needs --unix")
    if found["proxied"]:
        try:
            found["domain"] = domain_from_text(os.environ.get(VARIABLE, ""))
        except DomainError as error:
            parser.error(str(error))
    memory, disk = found.pop("memory") << 20, found.pop("disk") << 20
    processes, weight = found.pop("processes"), found.pop("cpu_weight")
    found["limits"] = Limits(memory=memory, disk=disk, processes=processes, cpu_weight=weight)
    found["data"] = _data(found["data"])
    found["base_url"] = found["base_url"] or ""
    found["lang"] = found["lang"] or language
    return ServerSettings(**found)


def is_loopback(host: str) -> bool:
    """Whether only this machine reaches that address."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def _data(given: Path | None) -> Path:
    """Where the files of the class are, by its one true name."""
    return (default_home().with_name("class") if given is None else given).expanduser().resolve()


def _word(text: str) -> str:
    if len(text.strip()) < SHORTEST_WORD:
        raise argparse.ArgumentTypeError(f"'{text}' is too easily guessed: {SHORTEST_WORD} characters at least")
    return text.strip()


def _address(text: str) -> str:
    """A path (`/user/anna/day6/`) or a whole address; it ends with a slash."""
    parts = urlsplit(text)
    if not (parts.scheme in ("http", "https") and parts.netloc) and not text.startswith("/"):
        raise argparse.ArgumentTypeError(f"'{text}' is no address: http://…, https://… or /…")
    return text if text.endswith("/") else f"{text}/"


def _minutes(text: str) -> float:
    try:
        minutes = float(text)
    except ValueError:
        minutes = -1.0
    if not 0 <= minutes <= 1e6:
        raise argparse.ArgumentTypeError(f"'{text}' is no number of minutes")
    return minutes


def _number(text: str, *, least: int, most: int) -> int:
    if not (text.isascii() and text.isdigit() and len(text) < 10 and least <= int(text) <= most):
        raise argparse.ArgumentTypeError(f"'{text}' is no number from {least} to {most}")
    return int(text)
