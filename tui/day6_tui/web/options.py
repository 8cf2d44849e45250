"""The options of `day6-tui serve`, explained in the user's language."""

from __future__ import annotations

import getpass
import ipaddress
import os
import sys
from functools import partial
from pathlib import Path

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.command_line.values import Values
from day6_core.graph.domain import VARIABLE, DomainError, domain_from_text
from day6_core.isolation.cell import Limits
from day6_core.isolation.modes import NAMES
from day6_core.places import default_home
from day6_tui.web.settings import ServerSettings

SHORTEST_WORD = 4
"""Characters of the class word: two tries a second are all anybody gets."""


STANDARD_INPUT = "-"


def build_parser(language: str = "en") -> CommandParser:
    """The options of the server."""
    parser = command_parser("serve", language)
    texts, values, add = parser.texts, Values(parser.texts), parser.add_argument
    add("--class", dest="class_file", type=Path, metavar="FILE.csv", help=texts("cli.serve.class"))
    add("--new-links", action="store_true", help=texts("cli.serve.new_links"))
    add("--word", type=partial(_word, values=values), metavar="FILE|WORD|-", help=texts("cli.serve.word"))
    add("--unasked", type=values.whole(0, 1000), default=8, metavar="N", help=texts("cli.serve.unasked"))
    add("--data", type=Path, metavar="DIR", help=texts("cli.serve.data"))
    add("--lessons", type=values.folder, metavar="DIR", help=texts("cli.desktop.lessons"))
    add("--most", type=values.whole(1, 1000), default=40, metavar="N", help=texts("cli.serve.most"))
    add("--idle", type=values.minutes, default=120.0, metavar="MIN", help=texts("cli.serve.idle"))
    add("--keep", action="store_true", help=texts("cli.serve.keep"))
    add("--isolation", choices=("auto", *NAMES), default="auto", help=texts("cli.serve.isolation"))
    most, megabytes, number = Limits(), values.whole(16, 1_000_000), values.whole(16, 100_000)
    add("--memory", type=megabytes, default=most.memory >> 20, metavar="MB", help=texts("cli.serve.memory"))
    add("--disk", type=megabytes, default=most.disk >> 20, metavar="MB", help=texts("cli.serve.disk"))
    add("--processes", type=number, default=most.processes, metavar="N", help=texts("cli.serve.processes"))
    weight = values.whole(1, 10_000)
    add("--cpu-weight", type=weight, default=most.cpu_weight, metavar="N", help=texts("cli.serve.cpu_weight"))
    add("--trust-pupils", action="store_true", help=texts("cli.serve.trust"))
    add("--host", default="127.0.0.1", metavar="ADDRESS", help=texts("cli.serve.host"))
    add("--port", type=values.whole(0, 65535), default=8006, metavar="N", help=texts("cli.serve.port"))
    add("--cert", dest="certificate", type=Path, metavar="FILE", help=texts("cli.serve.cert"))
    add("--key", type=Path, metavar="FILE", help=texts("cli.serve.key"))
    add("--base-url", type=values.address, metavar="URL", help=texts("cli.serve.base_url"))
    add("--unix", type=Path, metavar="SOCKET", help=texts("cli.serve.unix"))
    add("--proxied", action="store_true", help=texts("cli.serve.proxied"))
    add("--home", type=values.home, metavar="DIR", help=texts("cli.serve.home"))
    return parser


_NEEDS = (("--key", "key", "--cert", "certificate"), ("--new-links", "new_links", "--class", "class_file"),
          ("--home", "home", "--proxied", "proxied"), ("--proxied", "proxied", "--unix", "unix"))  # fmt: skip
"""An option, where its value is, and what it needs: any user of this machine reaches a port, so that a proxy gets a socket."""


def parse(words: list[str], language: str) -> ServerSettings:
    """The settings; a wrong word ends the program with status 2."""
    parser = build_parser(language)
    found = vars(parser.parse_args(words))
    if found["proxied"] and (found["class_file"] or found["word"]):
        parser.refuse("--proxied", parser.texts("cli.serve.not_with"))
    for option, name, other, needed in _NEEDS:
        if found[name] not in (None, False) and found[needed] in (None, False):
            parser.refuse(option, parser.texts("cli.error.needs", other=other))
    if found["proxied"]:
        try:
            found["domain"] = domain_from_text(os.environ.get(VARIABLE, ""))
        except DomainError as error:
            parser.error(str(error))
    found["word"], found["word_is_seen"] = found["word"] or (None, False)
    memory, disk = found.pop("memory") << 20, found.pop("disk") << 20
    processes, weight = found.pop("processes"), found.pop("cpu_weight")
    found["limits"] = Limits(memory=memory, disk=disk, processes=processes, cpu_weight=weight)
    found["data"] = _data(found["data"])
    found["base_url"] = found["base_url"] or ""
    found["desktop_lang"] = found["lang"] or ""
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


def _word(text: str, values: Values) -> tuple[str, bool]:
    """The class word, and whether others can read it where it was given: a word can be, but not a file and standard input."""
    from day6_core.link.secret import is_path, read_private
    from day6_core.link.unusable import Unusable

    if text != STANDARD_INPUT and not is_path(text):
        if len(text.strip()) < SHORTEST_WORD:
            raise values.wrong("word", text=text, least=SHORTEST_WORD)
        return text.strip(), True
    try:
        word = (_typed() if text == STANDARD_INPUT else read_private(text)).partition("\n")[0].strip()
        if len(word) < SHORTEST_WORD:
            raise Unusable("secret_short", where=text, count=len(word), least=SHORTEST_WORD)
    except Unusable as error:
        raise values.unusable(error) from None
    return word, False


def _typed() -> str:
    """A line of standard input, which the screen does not show if somebody types it."""
    return getpass.getpass("--word: ") if sys.stdin.isatty() else sys.stdin.readline()
