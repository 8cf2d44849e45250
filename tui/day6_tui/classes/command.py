"""`day6-tui class`: the desktop of a teacher or of a pupil of a class on a network. The options of the desktop go with it."""

from __future__ import annotations

import argparse
import os
import re
from functools import partial

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.command_line.texts import Wording
from day6_core.language import language_of
from day6_core.link.addresses import ROUTER_PORT, address_of, meant
from day6_core.link.classroom.keys import LONGEST_NAME, TEACHER, is_name
from day6_core.link.classroom.pupil import Pupil
from day6_core.link.classroom.teacher import Teacher
from day6_core.link.engine import why_no_zenoh
from day6_tui.commands import desktop


def build_parser(language: str = "en") -> CommandParser:
    """The options of the class, and those of the desktop behind them."""
    parser = command_parser("class", language)
    texts = parser.texts
    parser.used_as("--teacher [OPTION ...]", "--join HOST --name NAME [OPTION ...]")
    options = parser.arguments
    options.title = texts("cli.class.group")
    part = options.add_mutually_exclusive_group()
    told = texts("cli.class.teacher", port=ROUTER_PORT)
    part.add_argument("--teacher", action="store_true", help=told)
    told = texts("cli.class.join", port=ROUTER_PORT)
    part.add_argument("--join", type=partial(_endpoint, texts=texts), metavar="HOST[:PORT]", help=told)
    options.add_argument("--name", type=partial(_name, texts=texts), metavar="NAME", help=texts("cli.class.name"))
    options.add_argument("--room", action="store_true", help=texts("cli.class.room"))
    desktop.add_options(parser, port=ROUTER_PORT)
    return parser


def main(words: list[str]) -> int:
    """`day6-tui class [OPTION …]`; returns the exit status."""
    parser = build_parser(language_of(os.environ, words))
    options = parser.parse_args(words)
    _take_part(parser, options)
    return desktop.begin(parser, options, ["class", *words])


def _take_part(parser: CommandParser, options: argparse.Namespace) -> None:
    """Put the part in the class into the options of the desktop, in place of those of `class`; ends where they do not fit."""
    texts = parser.texts
    if why := why_no_zenoh(texts.language):
        parser.error(why)
    if options.connect:
        parser.error(texts("cli.class.connect"))
    elif options.teacher:
        if options.name is not None:
            parser.error(texts("cli.class.with_join", option="--name"))
        options.listen = options.listen or f"tcp/0.0.0.0:{ROUTER_PORT}"
        options.part = Teacher(room=options.room)
    elif options.join is None:
        parser.error(texts("cli.class.one"))
    elif options.name is None:
        parser.error(texts("cli.class.no_name"))
    elif options.room or options.listen:
        parser.error(texts("cli.class.with_teacher", option="--room" if options.room else "--listen"))
    else:
        options.connect, options.part = options.join, Pupil(options.name)
    del options.teacher, options.join, options.name, options.room


def _endpoint(text: str, texts: Wording) -> str:
    """Read a host with or without a port, or an endpoint."""
    endpoint = meant(text, ROUTER_PORT)
    port = endpoint.rpartition(":")[2]
    if port.isascii() and port.isdecimal() and (len(port) > 5 or not 1 <= int(port) <= 65535):
        raise argparse.ArgumentTypeError(texts("cli.class.port", text=text, port=port))
    try:
        address_of(endpoint, listening=False)
    except ValueError:
        raise argparse.ArgumentTypeError(texts("cli.class.endpoint", text=text)) from None
    return endpoint


def _name(text: str, texts: Wording) -> str:
    if not is_name(text):
        rule = texts(f"cli.class.name.{_broken_rule(text)}", name=text, most=LONGEST_NAME)
        raise argparse.ArgumentTypeError(rule)
    return text


def _broken_rule(name: str) -> str:
    """Which of the rules of a name this one breaks."""
    if name.lower() == TEACHER:
        return "teacher"
    if is_name(name[:LONGEST_NAME]):
        return "long"
    return "double" if is_name(re.sub("_+", "_", name)) else "letters"
