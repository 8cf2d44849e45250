"""`day6-tui cast FILE`: plays a recording, or writes its picture as SVG."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from day6_core.language import LANGUAGES, language_of
from day6_core.session.harmless import one_line
from day6_core.whole_file import replacing
from day6_tui.cast.file import Cast, CastError, read
from day6_tui.cast.film import Film
from day6_tui.command_line import parser_with_options
from day6_tui.locale import Texts

MOST_FRAMES = 100


def parser_of(texts: Texts) -> argparse.ArgumentParser:
    """The options of `day6-tui cast`."""
    parser, options = parser_with_options(texts, "day6-tui cast", "cli.cast")
    parser.add_argument("file", metavar="FILE.cast", type=Path, help=texts("cli.cast.file"))
    options.add_argument("--svg", metavar="OUT.svg", type=Path, help=texts("cli.cast.svg"))
    options.add_argument("--at", metavar="SECONDS", type=_seconds, help=texts("cli.cast.at"))
    options.add_argument("--frames", metavar="N", type=_count, default=1, help=texts("cli.cast.frames"))
    options.add_argument("--force", action="store_true", help=texts("cli.cast.force"))
    options.add_argument("--lang", choices=LANGUAGES, help=texts("cli.attach.lang"))
    return parser


def main(words: list[str]) -> int:
    """`day6-tui cast WORD…`; returns the exit status."""
    texts = Texts(language_of(os.environ, words))
    options = parser_of(texts).parse_args(words)
    try:
        cast = read(options.file)
    except OSError as error:
        return _refuse(f"{options.file}: {error.strerror or error}")
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
        return _refuse(f"{options.svg}: {error.strerror or error}")
    return 0


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = -1.0
    if not 0 <= seconds < 1e9:
        raise argparse.ArgumentTypeError(f"'{one_line(text)}' is no number of seconds")
    return seconds


def _count(text: str) -> int:
    if not (text.isascii() and text.isdigit() and 1 <= int(text[:9]) <= MOST_FRAMES):
        raise argparse.ArgumentTypeError(f"'{one_line(text)}' is no number from 1 to {MOST_FRAMES}")
    return int(text)


def _refuse(text: str) -> int:
    print(f"day6-tui: {one_line(text)}", file=sys.stderr)
    return 1
