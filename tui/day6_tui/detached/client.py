"""`day6-tui --detach` and `day6-tui attach`: start a kept desktop, come back to one."""

from __future__ import annotations

import os
import select
import shlex
import socket
import subprocess
import sys
from pathlib import Path

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.command_line.values import Values
from day6_core.language import language_of
from day6_core.link.paths import LinkError
from day6_core.session.harmless import one_line
from day6_tui.detached import wire
from day6_tui.detached.wire import Connection
from day6_tui.locale import Texts


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui attach`."""
    parser = command_parser("attach", language)
    values = Values(parser.texts)
    parser.add_argument("--home", type=values.home, metavar="DIR", help=parser.texts("cli.attach.home"))
    return parser


def main(words: list[str]) -> int:
    """`day6-tui attach [--home DIR]`; returns the exit status."""
    language = language_of(os.environ, words)
    options = build_parser(language).parse_args(words)
    texts = Texts(language)
    if sys.platform == "win32":
        return _refuse(texts("detached.windows"), 2)
    if not _has_terminal():
        return _refuse(texts("detached.no_terminal"), 2)
    from day6_tui.detached import meeting, view

    home = meeting.home_of(options.home)
    if os.environ.get(meeting.INSIDE) == str(home):
        return _refuse(texts("detached.inside"), 1)
    while True:
        try:
            connection = meeting.connect(home)
        except LinkError as error:
            return _refuse(one_line(str(error)), 1)
        if connection is None:
            return _refuse(texts("detached.none", command=_command(options.home, "--detach")), 1)
        status = view.show(Connection(connection), texts, _command(options.home, "attach"))
        if status is not None:
            return status


def start(words: list[str], home: Path | None, language: str) -> int:
    """`day6-tui --detach WORD…`: start the desktop under a keeper and show it here, if this is a terminal."""
    texts = Texts(language)
    if sys.platform == "win32":
        return _refuse(texts("detached.windows"), 2)
    from day6_tui.detached import meeting, view

    true_home = meeting.home_of(home)
    try:
        running = meeting.connect(true_home)
        held = meeting.hold(true_home) if running is None else None
    except BlockingIOError:
        held = None
    except OSError as error:
        return _refuse(one_line(f"{error.filename}: {error.strerror}" if error.strerror else str(error)), 1)
    if held is None:
        return _refuse(texts("detached.runs", command=_command(home, "attach")), 1)
    ours, theirs = socket.socketpair()
    descriptors = (held.listener.fileno(), held.lock, theirs.fileno())
    subprocess.Popen(
        [
            *(sys.executable, "-m", "day6_tui.detached.keeper"),
            *map(str, (*descriptors, true_home, os.getcwd())),
            *words,
        ],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        pass_fds=descriptors,
        start_new_session=True,
        cwd="/",  # no file of the user's folder is taken for one of Python's modules
    )
    theirs.close()
    held.close()
    if not _has_terminal():
        return _wait_until_it_runs(Connection(ours), view.hello(None), texts, home)
    status = view.show(Connection(ours), texts, _command(home, "attach"))
    return main(["--home", str(true_home), "--lang", texts.language]) if status is None else status


def _has_terminal() -> bool:
    return sys.stdin.isatty() and sys.stderr.isatty()


def _refuse(text: str, status: int) -> int:
    print(f"day6-tui: {text}", file=sys.stderr)
    return status


def _command(home: Path | None, word: str) -> str:
    """The command line that does something with the desktop of this home, to be read by a person."""
    return one_line(shlex.join(["day6-tui", word, *([] if home is None else ["--home", str(home)])]))


def _wait_until_it_runs(line: Connection, hello: bytes, texts: Texts, home: Path | None) -> int:
    line.send(wire.HELLO, hello)
    output = b""
    while not line.closed:
        select.select([line], [], [])
        for kind, data in line.receive():
            if kind == wire.OUTPUT:
                output += data
            elif kind == wire.READY:
                print(f"day6-tui: {texts('detached.started', command=_command(home, 'attach'))}")
                return 0
            elif kind == wire.END:
                last = output.rpartition(b"\x1b[?1004l")[2].decode(errors="replace").split("\n")
                for each in last:
                    if text := one_line(each.strip()):
                        print(text, file=sys.stderr)
                return int(data) or 1
    return _refuse(texts("detached.lost"), 1)
