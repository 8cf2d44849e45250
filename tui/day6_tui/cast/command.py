"""`day6-tui cast FILE`: plays a recording, or writes its picture as SVG."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.command_line.values import Values
from day6_core.language import language_of
from day6_core.reason import reason
from day6_core.session.harmless import one_line
from day6_core.whole_file import replacing
from day6_tui.cast.file import Cast, CastError, read
from day6_tui.cast.film import Film
from day6_tui.locale import Texts

MOST_FRAMES = 100


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui cast`, and what it takes."""
    parser = command_parser("cast", language)
    texts, values, add = parser.texts, Values(parser.texts), parser.add_argument
    add("file", metavar="FILE.cast", type=Path, help=texts("cli.cast.file"))
    add("--svg", metavar="OUT.svg", type=Path, help=texts("cli.cast.svg"))
    add("--at", metavar="SECONDS", type=values.seconds, help=texts("cli.cast.at"))
    add("--frames", metavar="N", type=values.whole(1, MOST_FRAMES), default=1, help=texts("cli.cast.frames"))
    add("--force", action="store_true", help=texts("cli.cast.force"))
    return parser


def main(words: list[str]) -> int:
    """`day6-tui cast WORD…`; returns the exit status."""
    language = language_of(os.environ, words)
    options = build_parser(language).parse_args(words)
    texts = Texts(language)
    try:
        cast = read(options.file)
    except OSError as error:
        return _refuse(f"{options.file}: {reason(error)}")
    except CastError as error:
        where = f"{options.file}:{error.line}" if error.line else str(options.file)
        return _refuse(f"{where}: {texts(f'cast.fault.{error.key}', **error.values)}")
    if options.svg is not None:
        return _export(cast, options, texts)
    if options.at is not None:
        film = Film(cast)
        film.go_to(options.at)
        for row in film.rows():
            print(one_line("".join(text for text, _ in row)).rstrip())
        return 0
    if sys.platform != "win32":
        if not (sys.stdin.isatty() and sys.stdout.isatty()):
            return _refuse(texts("cast.no_terminal"))
        from day6_tui.cast.player import play

        return play(Film(cast), texts)
    else:
        return _refuse(texts("cast.windows"))


def _export(cast: Cast, options: argparse.Namespace, texts: Texts) -> int:
    from day6_tui.cast.svg import picture

    if options.svg.exists() and not options.force:
        return _refuse(f"{options.svg}: {texts('cast.exists')}")
    film = Film(cast)
    if options.frames == 1:
        times = [cast.seconds if options.at is None else options.at]
    else:
        times = [cast.seconds * index / (options.frames - 1) for index in range(options.frames)]
    frames, width, height = [], 1, 1
    for time in times:
        film.go_to(time)
        frames.append(film.rows())
        width, height = max(width, film.size[0]), max(height, film.size[1])
    text = picture(frames, (width, height), [max(0.5, cast.seconds / len(frames))] * len(frames))
    try:
        with replacing(options.svg) as file:
            file.write(text.encode())
    except OSError as error:
        return _refuse(f"{options.svg}: {reason(error)}")
    return 0


def _refuse(text: str) -> int:
    print(f"day6-tui: {one_line(text)}", file=sys.stderr)
    return 1
