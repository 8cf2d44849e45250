"""The options of `day6-tui serve`, explained in the user's language."""

from __future__ import annotations

import argparse
from functools import partial
from pathlib import Path

from day6_tui.core.isolation.modes import NAMES
from day6_tui.tui.command_line import Formatter, folder
from day6_tui.tui.locale import Texts
from day6_tui.tui.web.settings import Settings


def build_parser(language: str = "en") -> argparse.ArgumentParser:
    """The options of the server."""
    texts = Texts(language)
    parser = argparse.ArgumentParser(
        prog="day6-tui serve",
        description=texts("cli.serve"),
        formatter_class=partial(Formatter, usage=texts("cli.usage")),
        add_help=False,
    )
    options = parser.add_argument_group(texts("cli.options"))
    options.add_argument("-h", "--help", action="help", help=texts("cli.help"))
    options.add_argument("--word", help=texts("cli.serve.word"))
    options.add_argument("--host", default="127.0.0.1", help=texts("cli.serve.host"))
    options.add_argument("--port", type=_port, default=8006, metavar="N", help=texts("cli.serve.port"))
    options.add_argument("--data", type=Path, metavar="DIR", help=texts("cli.serve.data"))
    options.add_argument("--isolation", choices=("auto", *NAMES), default="auto", help=texts("cli.serve.isolation"))
    options.add_argument("--trust-pupils", action="store_true", help=texts("cli.serve.trust"))
    options.add_argument(
        "--most", type=partial(_number, least=1), default=40, metavar="N", help=texts("cli.serve.most")
    )
    options.add_argument("--lessons", type=folder, metavar="DIR", help=texts("cli.lessons"))
    options.add_argument("--lang", choices=("zh", "en"), help=texts("cli.serve.lang"))
    return parser


def parse(words: list[str], language: str) -> Settings:
    """The settings; a wrong word ends the program with status 2, as argparse does."""
    parser = build_parser(language)
    found = vars(parser.parse_args(words))
    from day6_tui.tui.web.command import data_of

    found["data"] = data_of(found["data"])
    found["lang"] = found["lang"] or language
    return Settings(**found)


def _port(text: str) -> int:
    return _number(text, least=0, most=65535)


def _number(text: str, *, least: int, most: int = 1 << 31) -> int:
    if not (text.isascii() and text.isdigit() and least <= int(text) <= most):
        raise argparse.ArgumentTypeError(f"'{text}' is no number from {least} to {most}")
    return int(text)
