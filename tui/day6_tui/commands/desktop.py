"""The desktop: its options, and what must be true before it takes the screen."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from day6_core.command_line.parser import CommandParser, nearest, two_columns
from day6_core.command_line.texts import CommandTexts
from day6_core.command_line.values import Values
from day6_core.language import language_of
from day6_core.lessons.scene import scenes
from day6_core.ros.distribution import NAMES
from day6_core.virtual import surroundings
from day6_tui.appearance import themes
from day6_tui.commands.table import GROUPS, command_named, commands
from day6_tui.distribution_choice import KEEPER

_NAMES_COLUMN = 22
"""Where the list of commands says what they are for."""


def build_parser(language: str = "en") -> CommandParser:
    """The options of the desktop, and the list of commands."""
    texts = CommandTexts(language)
    parser = CommandParser("day6-tui", texts=texts, description=texts("cli.desktop"))
    parser.used_as("[OPTION ...]", "COMMAND [ARG ...]")
    parser.epilog = _command_list(texts)
    add_options(parser)
    parser.add_argument("--virtual-time", action="store_true", help=texts("cli.desktop.virtual_time"))
    return parser


def add_options(parser: CommandParser, *, lesson: bool = True, port: int | None = None) -> None:
    """Add what the desktop can be told; `class` takes it, too, which has a usual port, and `demo`, which has the lesson."""
    texts, values, add = parser.texts, Values(parser.texts), parser.add_argument
    add("--scene", choices=tuple(scenes()), help=texts("cli.desktop.scene"))
    add("--robot", type=values.file, metavar="FILE", help=texts("cli.desktop.robot"))
    add("--distro", choices=NAMES, help=texts("cli.desktop.distro"))
    glyphs = ("pixels", "half", "braille", "cell", "ascii")
    add("--glyphs", choices=glyphs, help=texts("cli.desktop.glyphs"))
    add("--theme", choices=themes.NAMES, help=texts("cli.desktop.theme"))
    add("--fps", type=values.number(1, 120), metavar="N", help=texts("cli.desktop.fps"))
    add("--reduced-motion", action="store_true", help=texts("cli.desktop.reduced_motion"))
    add("--home", type=values.home, metavar="DIR", help=texts("cli.desktop.home"))
    add("--lessons", type=values.folder, metavar="DIR", help=texts("cli.desktop.lessons"))
    if lesson:
        add("--lesson", metavar="NAME", known=lesson_names, help=texts("cli.desktop.lesson"))
    add("--record", type=Path, metavar="FILE.cast", help=texts("cli.desktop.record"))
    add("--detach", action="store_true", help=texts("cli.desktop.detach"))
    add(
        "--listen",
        type=values.endpoint(listening=True, port=port),
        metavar="ENDPOINT",
        help=texts("cli.desktop.listen"),
    )
    add("--connect", type=values.endpoint(listening=False), metavar="ENDPOINT", help=texts("cli.desktop.connect"))
    add("--secret", type=values.secret, metavar="FILE|WORD", help=texts("cli.desktop.secret"))
    none = argparse.SUPPRESS
    add("-V", "--version", action=_ShowVersion, nargs=0, dest=none, default=none, help=texts("cli.desktop.version"))


class _ShowVersion(argparse.Action):
    """argparse's own would have to know the version before anybody asks for it."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: str | Sequence[Any] | None,
        option_string: str | None = None,
    ) -> None:
        from day6_tui.main import show_version

        parser.exit(show_version())


def _command_list(texts: CommandTexts) -> str:
    """Every command with what it is for, by groups."""
    import shutil

    width = min(shutil.get_terminal_size().columns, 100) - 2
    colon = texts("cli.usage").rstrip()[-1:]
    lines = []
    for group in GROUPS:
        rows = [(each.name, each.summary(texts.language)) for each in commands() if each.group == group]
        lines += [texts(f"cli.group.{group}") + colon, *two_columns(rows, width, _NAMES_COLUMN), ""]
    return "\n".join([*lines, texts("cli.more")])


def lesson_names() -> list[str]:
    """The names of the lessons and drills that come with day6-tui."""
    from day6_core.lessons.catalogue import shipped_names

    return sorted(shipped_names())


def main(words: list[str]) -> int:
    """`day6-tui [OPTION …]`; returns the exit status."""
    parser = build_parser(language_of(os.environ, words))
    options, rest = parser.parse_known_args(words)
    if rest and command_named(rest[0]) is not None:
        parser.error(parser.texts("cli.error.command.behind", name=rest[0]))
    if rest:
        parser.refuse_unknown(rest)
    virtual = options.virtual_time
    del options.virtual_time
    if virtual and (status := _enter_virtual_time(parser, options)) is not None:
        return status
    return begin(parser, options, words)


def _enter_virtual_time(parser: CommandParser, options: argparse.Namespace) -> int | None:
    """Become the first process of a world in virtual time; None if this is it already, else the status where it can't be."""
    from day6_core.shell.outward.fast import begin_anew_or_say
    from day6_core.virtual.surroundings import is_virtual

    for other in ("detach", "listen", "connect"):
        if getattr(options, other):
            parser.refuse("--virtual-time", parser.texts("cli.error.not_with", other=f"--{other}"))
    if is_virtual() or not (sys.stdin.isatty() and sys.stderr.isatty()):
        return None
    return begin_anew_or_say(parser, sys.orig_argv, os.environ, paced=True)


def begin(parser: CommandParser, options: argparse.Namespace, words: list[str]) -> int:
    """Open the desktop that `words` asked for, as `parser` read them; refuse what cannot be. Returns the status."""
    texts = parser.texts
    keeper = _kept_by()
    if options.secret is not None and not (options.listen or options.connect):
        parser.refuse("--secret", texts("cli.error.needs", other="--listen, --connect"))
    if options.lesson is not None:
        _look_for_lesson(parser, options)
    if options.detach and keeper is None:
        from day6_tui.detached.client import start

        return start(words, options.home, texts.language)
    if not (sys.stdin.isatty() and sys.stderr.isatty()):  # Textual draws on stderr
        return _refuse(texts("cli.no_terminal"))
    from day6_tui import textual_private

    if not textual_private.supported():
        there, tested = textual_private.version(), textual_private.TESTED
        return _refuse(texts("cli.textual", version=there, tested=tested))
    if options.record is not None and "DAY6_REWIND" not in os.environ:
        options.record = options.record.absolute()
        if (reason := _cannot_be_made(options.record, texts.language)) is not None:
            return _refuse(reason)
    from day6_tui.app import run
    from day6_tui.options import Options

    del options.detach
    if surroundings.pace is not None:
        from day6_core.places import default_home
        from day6_tui.features import rewind

        try:
            options.home, options.past = rewind.begin(options.home or default_home())
        except OSError as error:
            from day6_core.reason import named_reason

            return _refuse(named_reason(error))
        options.record = options.record if options.past is None else None  # it has its film already
    return run(Options(**vars(options), keeper=keeper))


def _look_for_lesson(parser: CommandParser, options: argparse.Namespace) -> None:
    """Refuse the name of a lesson that is not there; a mistake in its file is shown on the desktop."""
    from day6_core.ros.environment import activate

    activate()
    from day6_core.lessons.catalogue import offer

    found = offer(options.lessons)
    name, texts = options.lesson, parser.texts
    if found.named(name) is None and not any(name == each.path.stem for each in found.broken):
        names = [each.name for each in found.lessons]
        close = nearest(name, [each.name for each in found.all], 0.8)
        key = "cli.wrong.lesson.close" if close else "cli.wrong.lesson" if names else "cli.wrong.lesson.none"
        option = "DAY" if getattr(options, "demo", False) else "--lesson"
        parser.refuse(option, texts(key, name=name, names=", ".join(names), close=close))


def _refuse(text: str) -> int:
    print(f"day6-tui: {text}", file=sys.stderr)
    return 2


def _cannot_be_made(path: Path, language: str) -> str | None:
    """Why a new file cannot be made, before there is a screen over it; None if it can."""
    from day6_core.session.harmless import one_line
    from day6_tui.locale import Texts

    texts = Texts(language)
    if path.exists() or path.is_symlink():
        return one_line(f"{path}: {texts('cast.exists.record')}")
    if not path.parent.is_dir() or not os.access(path.parent, os.W_OK):
        return one_line(f"{path}: {texts('cast.no_folder')}")
    return None


def _kept_by() -> int | None:
    """The descriptor of the line to the keeper that started this desktop; also goes to the folder the user is in."""
    import contextlib

    descriptor, _, folder = os.environ.pop(KEEPER, "").partition(":")
    if not descriptor.isdecimal():
        return None
    os.set_inheritable(int(descriptor), False)
    with contextlib.suppress(OSError):  # it is gone by now
        os.chdir(folder)
    return int(descriptor)
