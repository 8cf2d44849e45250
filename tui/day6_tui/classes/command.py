"""`day6-tui class`: the desktop of a teacher or of a pupil of a class on a network. The options of the desktop go with it."""

from __future__ import annotations

import argparse
import re
from functools import partial

from day6_core.link.addresses import ROUTER_PORT, address_of
from day6_core.link.classroom.keys import LONGEST_NAME, TEACHER, is_name
from day6_core.link.classroom.pupil import Pupil
from day6_core.link.classroom.teacher import Teacher
from day6_tui.command_line import build_parser
from day6_tui.locale import Texts


def class_parser(language: str = "en") -> argparse.ArgumentParser:
    """The options of the desktop, and those of the class before them."""
    texts = Texts(language)
    parser = build_parser(language)
    parser.prog, parser.description, parser.epilog = "day6-tui class", texts("cli.class"), None
    options = parser.add_argument_group(texts("cli.class.group"))
    parser._action_groups.insert(-2, parser._action_groups.pop())
    part = options.add_mutually_exclusive_group()
    told = texts("cli.class.teacher", port=ROUTER_PORT)
    part.add_argument("--teacher", action="store_true", help=told)
    told = texts("cli.class.join", port=ROUTER_PORT)
    part.add_argument("--join", type=partial(_endpoint, texts=texts), metavar="HOST[:PORT]", help=told)
    options.add_argument("--name", type=partial(_name, texts=texts), metavar="NAME", help=texts("cli.class.name"))
    options.add_argument("--room", action="store_true", help=texts("cli.class.room"))
    return parser


def take_part(parser: argparse.ArgumentParser, options: argparse.Namespace, texts: Texts) -> None:
    """Put the part in the class into the options of the desktop, in place of those of `class`; ends where they do not fit."""
    if options.version:
        options.part = None
    elif options.connect:
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


def _endpoint(text: str, texts: Texts) -> str:
    """Read a host with or without a port, or an endpoint."""
    bare_ipv6 = text.count(":") > 1 and not text.startswith("[")
    host = f"[{text}]" if bare_ipv6 else text
    port = host.rpartition(":")[2] if ":" in host and not host.endswith("]") else ""
    has_port = port.isascii() and port.isdecimal()
    if has_port and (len(port) > 5 or not 1 <= int(port) <= 65535):
        raise argparse.ArgumentTypeError(texts("cli.class.port", text=text, port=port))
    for endpoint in (text, f"tcp/{host}" if has_port else f"tcp/{host}:{ROUTER_PORT}"):
        try:
            address_of(endpoint, listening=False)
        except ValueError:
            continue
        return endpoint
    raise argparse.ArgumentTypeError(texts("cli.class.endpoint", text=text))


def _name(text: str, texts: Texts) -> str:
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
